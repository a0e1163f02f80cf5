#!/usr/bin/env bash
# map_costs.sh [--accept]: instructions of small maps by the release build, beside those in
# results/golden/map_instructions.csv. Exits 1 where a map takes 3 % more; --accept moves the numbers on, in a commit that
# says why maps may be dearer (or are cheaper) now. Instructions do not depend on what else the machine does.
# map_costs.sh BEFORE AFTER [PAIRS]: two builds (directories of programs) over six maps: instructions of each, their ratio,
# and the ratio of processor times, the median of PAIRS (5) runs in turn.
# Needs valgrind. One thread; the mathematical functions are those for any processor, as another one has others.
set -euo pipefail
export LC_ALL=C.UTF-8 GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA,-FMA4,-ERMS,-BMI2
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
numbers=$top/results/golden/map_instructions.csv
guarded=(benchmark/one_side benchmark/annulus rotor_kit)
compared=("${guarded[@]}" benchmark/both_sides hard_case/one_side light_casing/both_sides)
allowed_percent=3
command -v valgrind >/dev/null || { echo 'map_costs.sh: needs valgrind (Debian package: valgrind)' >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# cells NAME FACTOR: cells along an axis; a kit's cell costs as much as a hundred of others.
cells() { [[ $1 == rotor_kit ]] && echo "$2" || echo $((3 * $2)); }

# map PROGRAMS NAME [COMMAND...]: the map of configs/NAME.yaml, of few cells, by rubsweep of PROGRAMS under COMMAND.
map() {
  local programs=$1 name=$2
  shift 2
  "$@" "$programs/rubsweep" "$top/configs/$name.yaml" --quiet --fresh --threads 1 --output "$work/map" \
    --set "sweep.speed_hz.count=$(cells "$name" 3)" --set "sweep.whirl_ratio.count=$(cells "$name" 2)" >"$work/said" 2>&1 || (($? == 4))
}

instructions() {
  map "$1" "$2" valgrind --tool=callgrind --callgrind-out-file=/dev/null
  sed -n 's/.*Collected : //p' "$work/said"
}

seconds() {
  map "$1" "$2" bash -c 'TIMEFORMAT="%U"; time "$@" >/dev/null 2>&1' timed
  tail -n 1 "$work/said"
}

percent() { awk "BEGIN { printf \"%+.2f\", 100 * ($2 / $1 - 1) }"; }

compare_builds() {
  local before=$1 after=$2 pairs=${3:-5} name was is i
  for name in "${compared[@]}"; do
    was=$(instructions "$before" "$name")
    is=$(instructions "$after" "$name")
    for ((i = 0; i < pairs; ++i)); do
      awk "BEGIN { was = $(seconds "$before" "$name"); print (was > 0 ? $(seconds "$after" "$name") / was : 1) }"
    done | sort -g >"$work/ratios"
    echo "$name: $was -> $is instructions, $(percent "$was" "$is") %," \
      "processor time x $(sed -n "$(((pairs + 1) / 2))p" "$work/ratios")"
  done
}

compare_with_numbers() {
  local programs=$top/build/release/apps name was is dearer=0
  for name in "${guarded[@]}"; do
    is=$(instructions "$programs" "$name")
    was=$(sed -n "s|^$name,||p" "$numbers")
    echo "$name: $is instructions, $(percent "$was" "$is") %"
    awk "BEGIN { exit !($is > (1 + $allowed_percent / 100) * $was) }" || continue
    dearer=1
    echo "map_costs.sh: $name has become more than $allowed_percent % dearer than results/golden/map_instructions.csv" >&2
  done
  ((dearer == 0)) || echo 'map_costs.sh: if that is meant: scripts/map_costs.sh --accept, and say why' >&2
  return "$dearer"
}

accept() {
  local name
  {
    echo map,instructions
    for name in "${guarded[@]}"; do echo "$name,$(instructions "$top/build/release/apps" "$name")"; done
  } >"$work/numbers"
  mv "$work/numbers" "$numbers"
  cat "$numbers"
}

case $# in
  0) compare_with_numbers ;;
  1) [[ $1 == --accept ]] || { echo 'usage: map_costs.sh [--accept | BEFORE AFTER [PAIRS]]' >&2; exit 2; }
     accept ;;
  *) compare_builds "$@" ;;
esac
