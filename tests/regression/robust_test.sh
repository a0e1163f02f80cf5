#!/usr/bin/env bash
# robust_test.sh RUBSWEEP CONFIG SENSITIVE_CELLS: with response.robustness the column `robust` says no for the cells
# that are known to hang by a thread, and yes for their neighbours.
set -euo pipefail
rubsweep=$1 config=$2 sensitive=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$rubsweep" "$config" --output . --quiet --set response.robustness=on \
  --set 'sweep={speed_hz: {values: [111, 141]}, whirl_ratio: {values: [0.17, 0.97]}}'
grep -v -e '^#' -e '^speed_hz,' map.csv | awk -F, '{ print $1 "," $2 "," $9 }' | sort >found
grep -v -e '^#' -e '^speed_hz,' "$sensitive" | awk -F, '$1 > 100 && $2 == 0.97 { print $1 "," $2 ",no" }' | sort >known
[[ $(wc -l <known) == 2 ]] || { echo 'other cells are listed: choose neighbours anew'; exit 1; }
diff known <(grep ',no$' found) || { echo 'the cells that are not robust are others'; exit 1; }
[[ $(grep -c ',yes$' found) == 2 ]] || { echo 'the others are not robust either'; exit 1; }
