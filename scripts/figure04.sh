#!/usr/bin/env bash
# figure04.sh [OUTPUT_BASENAME]: a kick after which rub persists, set A, as OUTPUT_BASENAME.png and .svg.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/trace_figure.sh" figure06_one_side figure04 'Rub persists after the kick' 40 "${1:-}" 75:0.3
