#!/usr/bin/env bash
# all_figures.sh: every map and every behaviour panel, as results/figures/*.png and .svg. Computes the maps that
# results/ does not hold: about three minutes on two cores for all of them, then one.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

for number in 04 05 06 07 08 09 10 11 12 13; do
  echo "figure $number"
  "$here/figure$number.sh"
done
echo 'both sides, unequal casings'
"$here/map_figure.sh" both_sides_unequal both_sides_unequal 'Rub domains after a kick, unequal casings on both sides'
