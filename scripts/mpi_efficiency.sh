#!/usr/bin/env bash
# mpi_efficiency.sh [RANKS] [CONFIG.yaml [OPTION]...]: the same map by one process of one thread and by RANKS (2) ranks of
# one thread, three times each, alternating: medians on the wall clock and of processor time, and the efficiency, which
# means something on an idle machine only. Default: the map of figure 9, twelve times as fine.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
ranks=${1:-2}
shift || true
(($# > 0)) || set -- "$top/configs/figure09_both_sides.yaml" --set sweep.speed_hz.count=264 --set sweep.whirl_ratio.count=60
programs=$top/build/release/apps
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# measure NAME COMMAND...: appends its times, "wall processor" in seconds, to $work/NAME.
measure() {
  local name=$1 TIMEFORMAT='%R %U %S'
  shift
  rm -rf "$work/map"
  { time "$@" --quiet --threads 1 --output "$work/map"; } 2>&1 | awk '{ print $1, $2 + $3 }' >>"$work/$name"
  cmp "$work/map/map.csv" "${first:-$work/map/map.csv}"
  [[ -n ${first:-} ]] || { first=$work/first.csv && cp "$work/map/map.csv" "$first"; }
}
for _ in 1 2 3; do
  measure one "$programs/rubsweep" "$@"
  measure ranks mpirun -n "$ranks" --bind-to none "$programs/rubsweep-mpi" "$@"
done

median() { sort -n -k "$2,$2" "$work/$1" | awk -v column="$2" 'NR == 2 { print $column }'; }
awk -v n="$ranks" -v a="$(median one 1)" -v b="$(median ranks 1)" -v c="$(median one 2)" -v d="$(median ranks 2)" 'BEGIN {
  printf "one process: %.2f s, %.2f s of processor time\n%d ranks: %.2f s, %.2f s of processor time\n", a, c, n, b, d
  printf "efficiency: %.0f %% on the wall clock, %.0f %% in processor time\n", 100 * a / (n * b), 100 * c / d
}'
