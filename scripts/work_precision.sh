#!/usr/bin/env bash
# work_precision.sh TABLE.csv OUTPUT_BASENAME HEADING: draws what rubbench wrote as OUTPUT_BASENAME.png, error against
# processor time per revolution, a row of panels for every cell. Variants that failed are left out.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_work_precision.py" "$@"
