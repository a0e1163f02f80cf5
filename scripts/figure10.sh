#!/usr/bin/env bash
# figure10.sh [OUTPUT_BASENAME]: circle and self-excited whirls in a centred annulus, as OUTPUT_BASENAME.png and .svg.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/trace_figure.sh" figure11_annulus figure10 'Motions in a centred annulus' -20 "${1:-}" 60:0.8 99:0.45 180:0.8 210:0.6
