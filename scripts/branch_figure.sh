#!/usr/bin/env bash
# branch_figure.sh DIR OUTPUT_BASENAME HEADING: draws what rubbranch wrote into DIR as OUTPUT_BASENAME.png and .svg:
# amplitude over the parameter, stable orbits in full lines and unstable ones dashed, events marked.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_branch.py" "$@"
