#!/usr/bin/env bash
# bifurcation.sh DIR OUTPUT_BASENAME HEADING: draws what rubline wrote into DIR as OUTPUT_BASENAME.png and .svg:
# section points and largest displacement along the line, coloured by class.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_bifurcation.py" "$@"
