#!/usr/bin/env bash
# run_up.sh DIR OUTPUT_BASENAME HEADING: draws what rubtrace --run-up --with-stops wrote into DIR as OUTPUT_BASENAME.png
# and .svg: a strip of orbits, the envelope with the steady motions, where it rubs, and the spectrogram over orders.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_run_up.py" "$@"
