#!/usr/bin/env bash
# figure07.sh [OUTPUT_BASENAME]: subharmonic motions 1/2 to 1/5 against one stop, set A, as OUTPUT_BASENAME.png
# and .svg.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")

program=$top/build/release/apps/rubtrace
[[ -x $program ]] || { echo "figure07.sh: no $program; cmake --preset release && cmake --build --preset release" >&2; exit 1; }
traces=()
for speed_hz in 72 111 150 186; do
  trace=$top/results/figure07_trace/${speed_hz}_hz
  "$program" "$top/configs/figure06_one_side.yaml" --speed-hz "$speed_hz" --whirl-ratio 0.15 --last-revolutions 128 \
    --output "$trace"
  traces+=("$trace")
done
"$here/trace.sh" "${traces[0]}" "${1:-$top/results/figures/figure07}" 'Subharmonic motions against one stop' -20 "${traces[@]:1}"
