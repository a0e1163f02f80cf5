#!/usr/bin/env bash
# robust_test.sh RUBSWEEP CONFIG SENSITIVE_CELLS TOP: with response.robustness the column `robust` says no for the cells
# that are known to hang by a thread, and yes for their neighbours.
set -euo pipefail
rubsweep=$1 config=$2 sensitive=$3 top=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$rubsweep" "$config" --output . --quiet --set response.robustness=on \
  --set 'sweep={speed_hz: {values: [111, 141]}, whirl_ratio: {values: [0.17, 0.97]}}'
cells() { PYTHONPATH=$top/scripts python3 -B "$top/scripts/analysis/csv_columns.py" "$@"; }
cells map.csv speed_hz whirl_ratio robust | sort >found
cells "$sensitive" speed_hz whirl_ratio | grep -E '^[0-9]{3}.*,0\.97$' | sed 's/$/,no/' | sort >known
[[ $(wc -l <known) == 2 ]] || { echo 'other cells are listed: choose neighbours anew'; exit 1; }
diff known <(grep ',no$' found) || { echo 'the cells that are not robust are others'; exit 1; }
[[ $(grep -c ',yes$' found) == 2 ]] || { echo 'the others are not robust either'; exit 1; }
