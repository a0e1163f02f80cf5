#!/usr/bin/env bash
# figure13.sh [OUTPUT_BASENAME]: circle, 1/2, 1/3 and quasi-periodic motion in an annulus with offset, as OUTPUT_BASENAME.png and .svg.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/trace_figure.sh" figure12_annulus_offset figure13 'Motions in an annulus with offset' -20 "${1:-}" 60:0.8 66:0.4 99:0.75 210:0.8
