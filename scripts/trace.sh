#!/usr/bin/env bash
# trace.sh TRACE_DIR OUTPUT_BASENAME HEADING [REVOLUTIONS [TRACE_DIR]...]: draws what rubtrace wrote as
# OUTPUT_BASENAME.png and .svg: time history, orbit and full spectrum, one row of panels per trace.
# The history shows the first REVOLUTIONS after the start of the run (default 40), or of what rubtrace --last-revolutions
# left of it, or the last ones where the number is negative. Orbit and section points are those of the end of the run.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_traces.py" "$@"
