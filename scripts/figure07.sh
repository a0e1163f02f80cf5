#!/usr/bin/env bash
# figure07.sh [OUTPUT_BASENAME]: subharmonic motions 1/2 to 1/5 against one stop, set A, as OUTPUT_BASENAME.png and .svg.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/trace_figure.sh" figure06_one_side figure07 'Subharmonic motions against one stop' -20 "${1:-}" 72:0.15 111:0.15 150:0.15 186:0.15
