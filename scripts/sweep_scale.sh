#!/usr/bin/env bash
# sweep_scale.sh [CELLS...]: sweeps of set A with coarse settings, by default 1e3, 1e4, 1e5 and 1e6 cells, nearly half of
# which keep rubbing: peak memory, processor time and cells per processor second of each, as a table. Takes about three
# minutes of processor time and 1 GB of disk for 1e6 cells. THREADS (2) and RUBSWEEP (the program) come from outside.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")
program=${RUBSWEEP:-$top/build/release/apps/rubsweep}
[[ -x $program ]] || { echo "sweep_scale.sh: no $program; run scripts/test.sh" >&2; exit 1; }
[[ -x /usr/bin/time ]] || { echo 'sweep_scale.sh: needs GNU time (Debian package: time)' >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo '| cells | in contact at the end | peak memory, MB | processor time, s | cells per processor second |'
echo '|---|---|---|---|---|'
(($# > 0)) || set -- 1000 10000 100000 1000000
for count in "$@"; do
  read -r speeds ratios < <(python3 "$here/analysis/sweep_scale.py" grid "$count")
  /usr/bin/time -o "$work/time" -f '%M %U %S' "$program" "$top/configs/minimal.yaml" --quiet --threads "${THREADS:-2}" \
    --set "sweep={speed_hz: {from: 60, to: 80, count: $speeds}, whirl_ratio: {from: 0.05, to: 0.5, count: $ratios}}" \
    --set 'response={window_revolutions: 12, samples_per_revolution: 32, max_order: 6, max_revolutions: 200}' \
    --output "$work/map" || (($? == 4))
  python3 "$here/analysis/sweep_scale.py" row "$work/time" "$work/map/map.csv"
  rm -rf "$work/map"
done
