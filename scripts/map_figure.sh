#!/usr/bin/env bash
# map_figure.sh [--fade] CONFIG_STEM FIGURE HEADING [MAP.csv] [OUTPUT_BASENAME]: draws results/CONFIG_STEM/map.csv as
# results/figures/FIGURE.png and .svg. Without a MAP argument computes the map first if it is not there.
# --fade fades cells by their robust_share, see domain_map.sh.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")

fade=()
if [[ ${1-} == --fade ]]; then
  fade=(fade)
  shift
fi
(($# >= 3 && $# <= 5)) || {
  echo 'map_figure.sh: usage: map_figure.sh [--fade] CONFIG_STEM FIGURE HEADING [MAP.csv] [OUTPUT_BASENAME]' >&2
  exit 1
}
stem=$1 figure=$2 heading=$3
map=${4:-$top/results/$stem/map.csv}
output=${5:-$top/results/figures/$figure}
if (($# == 3)) && [[ ! -e $map ]]; then
  program=$top/build/release/apps/rubsweep
  [[ -x $program ]] || { echo "$figure.sh: no $map and no $program; run scripts/quickstart.sh" >&2; exit 1; }
  # 4: done, but some cells failed; the figure shows which.
  "$program" "$top/configs/$stem.yaml" --output "$(dirname "$map")" || (($? == 4))
fi
"$here/domain_map.sh" "$map" "$output" "$heading" "${fade[@]}"
