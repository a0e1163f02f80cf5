#!/usr/bin/env bash
# golden_test.sh RUBSWEEP RUBSWEEP_COMPARE CONFIG GOLDEN_MAP SENSITIVE_CELLS SETTING: the map of CONFIG with SETTING is
# the golden one on every cell that is not sensitive; those are few, though this map looks for the rims on purpose.
set -euo pipefail
rubsweep=$1 compare=$2 config=$3 golden=$4 sensitive=$5 setting=$6
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$rubsweep" "$config" --output "$work" --quiet --set "$setting"
"$compare" "$golden" "$work/map.csv" --sensitive "$sensitive"
rows() { grep -cv -e '^#' -e '^speed_hz,' "$1"; }
listed=$(rows "$sensitive") cells=$(rows "$golden")
((100 * listed <= 4 * cells)) || { echo "$listed of $cells cells are listed as sensitive, allowed: 4 %"; exit 1; }
