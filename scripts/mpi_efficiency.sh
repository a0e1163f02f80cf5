#!/usr/bin/env bash
# mpi_efficiency.sh [RANKS] [CONFIG.yaml [OPTION]...]: the same map by one process of one thread and by RANKS (2) ranks of
# one thread, three times each, alternating: medians on the wall clock and of processor time, and the efficiency, which
# means something on an idle machine only. Default: the benchmark between two stops, twelve times as fine.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")
ranks=${1:-2}
shift || true
(($# > 0)) || set -- "$top/configs/benchmark/both_sides.yaml" --set sweep.speed_hz.count=264 --set sweep.whirl_ratio.count=60
programs=$top/build/release/apps
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
exec 3>&2 # what the programs say is no time

# measure NAME COMMAND...: appends its times, "real user system" in seconds, to $work/NAME.
measure() {
  local name=$1 TIMEFORMAT='%R %U %S'
  shift
  rm -rf "$work/map"
  { time "$@" --quiet --threads 1 --output "$work/map" 2>&3; } 2>>"$work/$name"
  cmp "$work/map/map.csv" "${first:-$work/map/map.csv}"
  [[ -n ${first:-} ]] || { first=$work/first.csv && cp "$work/map/map.csv" "$first"; }
}
for _ in 1 2 3; do
  measure one "$programs/rubsweep" "$@"
  measure ranks mpirun -n "$ranks" --bind-to none "$programs/rubsweep-mpi" "$@"
done

python3 "$here/analysis/mpi_efficiency.py" "$work/one" "$work/ranks" "$ranks"
