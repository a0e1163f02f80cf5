#!/usr/bin/env bash
# basin_figure.sh DIR OUTPUT_BASENAME HEADING: draws the slice that rubbasin wrote into DIR as OUTPUT_BASENAME.png and
# .svg: every start in the colour of the attractor that it leads to.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_basin.py" "$@"
