#!/usr/bin/env bash
# trace_figure.sh CONFIG_STEM FIGURE HEADING REVOLUTIONS OUTPUT_BASENAME SPEED_HZ:WHIRL_RATIO...: runs the cells of
# configs/CONFIG_STEM.yaml and draws a row of panels for each (time history, orbit, full spectrum) as
# OUTPUT_BASENAME.png and .svg, results/figures/FIGURE where that is empty. REVOLUTIONS as in trace.sh: the first ones
# after the kick, or the last ones where negative. A cell "CONFIG_STEM/SPEED_HZ:WHIRL_RATIO" takes another configuration.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")

stem=$1 figure=$2 heading=$3 revolutions=$4 output=${5:-$top/results/figures/$2}
program=$top/build/release/apps/rubtrace
[[ -x $program ]] || { echo "$figure.sh: no $program; cmake --preset release && cmake --build --preset release" >&2; exit 1; }

# The orbit needs a window at the end of the run; only a history from the kick on needs all of it.
span=(--revolutions 600)
((revolutions >= 0)) || span=(--last-revolutions 128)
traces=()
for cell in "${@:6}"; do
  config=$stem
  [[ $cell != */* ]] || config=${cell%/*} cell=${cell#*/}
  trace=$top/results/${figure}_trace/${config}_${cell%:*}_hz_${cell#*:}
  "$program" "$top/configs/$config.yaml" --speed-hz "${cell%:*}" --whirl-ratio "${cell#*:}" "${span[@]}" --output "$trace"
  traces+=("$trace")
done
"$here/trace.sh" "${traces[0]}" "$output" "$heading" "$revolutions" "${traces[@]:1}"
