#!/usr/bin/env bash
# bode.sh DIR OUTPUT_BASENAME HEADING: draws what rubtrace --run-up wrote into DIR as OUTPUT_BASENAME.png and .svg: a Bode
# plot of every sensor, amplitude and phase of the component that turns with the shaft over its speed.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_bode.py" "$@"
