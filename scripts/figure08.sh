#!/usr/bin/env bash
# figure08.sh [OUTPUT_BASENAME]: synchronous, 1/3 and 1/5 motions between two stops, as OUTPUT_BASENAME.png and .svg.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/trace_figure.sh" figure09_both_sides figure08 'Motions between stops on both sides' -20 "${1:-}" 75:0.4 180:0.15 219:0.12
