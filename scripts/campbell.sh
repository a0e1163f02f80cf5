#!/usr/bin/env bash
# campbell.sh DIR OUTPUT_BASENAME HEADING: draws what rubtrace --campbell wrote into DIR as OUTPUT_BASENAME.png and .svg:
# whirl frequencies over the shaft speed, critical speeds, and of a rotor kit the mode shapes along the shaft.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_campbell.py" "$@"
