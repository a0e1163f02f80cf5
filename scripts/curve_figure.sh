#!/usr/bin/env bash
# curve_figure.sh DIR OUTPUT_BASENAME HEADING [MAP.csv]: draws what rubbranch --curve wrote into DIR as
# OUTPUT_BASENAME.png and .svg: curves in the plane of both parameters by their kind and order, meetings marked and named.
# With a map over speed and unbalance its cells stand behind them; the curves must then be in the same plane.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_curves.py" "$@"
