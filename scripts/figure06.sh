#!/usr/bin/env bash
# figure06.sh [MAP.csv] [OUTPUT_BASENAME]: draws the domain map of the one-side stop as OUTPUT_BASENAME.png and .svg.
# Without a map takes results/figure06_one_side/map.csv, and computes it first if it is not there.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")

map=${1:-$top/results/figure06_one_side/map.csv}
output=${2:-$top/results/figures/figure06}
if (($# == 0)) && [[ ! -e $map ]]; then
  program=$top/build/release/apps/rubsweep
  [[ -x $program ]] || { echo "figure06.sh: no $map and no $program; run scripts/quickstart.sh" >&2; exit 1; }
  # 4: done, but some cells failed; the figure shows which.
  "$program" "$top/configs/figure06_one_side.yaml" --output "$(dirname "$map")" || (($? == 4))
fi
"$here/domain_map.sh" "$map" "$output" 'Rub domains after a kick, stop on one side'
