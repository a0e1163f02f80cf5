#!/usr/bin/env bash
# figure05.sh [OUTPUT_BASENAME]: a kick after which rub dies out, set A, as OUTPUT_BASENAME.png and .svg.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/trace_figure.sh" figure06_one_side figure05 'Rub dies out after the kick' 40 "${1:-}" 90:0.3
