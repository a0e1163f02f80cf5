#!/usr/bin/env bash
# cascade.sh DIR OUTPUT_BASENAME HEADING: draws what rubline wrote into DIR as OUTPUT_BASENAME.png and .svg:
# full spectra along the line, one panel for each pass, backward orders on the left.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_cascade.py" "$@"
