#!/usr/bin/env bash
# compare_outputs.sh BUILD_BEFORE BUILD_AFTER [--grid SPEEDS UNBALANCES]: what a change of the code's shape must not change. Runs
# rubsweep on every shipped configuration, rubtrace on one cell of each and ringstab on every ring with the programs of both
# build directories and compares every byte of what they write but for the line `# digest` and, in motion.csv and map.csv,
# `# rubsweep VERSION`. --grid takes fewer cells of every map. Lists what differs; exits with 5 where something does.
set -euo pipefail
usage() { echo 'usage: compare_outputs.sh BUILD_BEFORE BUILD_AFTER [--grid SPEEDS UNBALANCES]' >&2; exit 1; }
(($# == 2 || $# == 5)) || usage
before=$(realpath -- "$1") after=$(realpath -- "$2") grid=()
if (($# == 5)); then
  [[ $3 == --grid && $4 =~ ^[1-9][0-9]*$ && $5 =~ ^[1-9][0-9]*$ ]] || usage
  grid=(--set "sweep.speed_hz.count=$4" --set "sweep.whirl_ratio.count=$5")
fi
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

differ=0
# same NAME: every file below before/NAME is there in after/NAME with the same bytes.
same() {
  local file
  for build in before after; do
    find "$work/$build/$1" -type f -name '*.csv' -exec sed -i -E '/^# (digest|rubsweep) /d' {} +
  done
  if diff -rq "$work/before/$1" "$work/after/$1" >"$work/differences"; then
    file=$(find "$work/before/$1" -type f | wc -l)
    echo "$1: $file files, the same"
  else
    sed "s|$work/||g" "$work/differences"
    differ=5
  fi
}

# both NAME PROGRAM ARGUMENT...: runs it with both builds into NAME. Cells that fail are rows, too.
both() {
  local name=$1 program=$2 build code
  shift 2
  for build in before after; do
    code=0
    "${!build}/apps/$program" "$@" --output "$work/$build/$name" --quiet || code=$?
    ((code == 0 || code == 4)) || { echo "$name: $program of $build ends with $code" >&2; exit "$code"; }
  done
  same "$name"
}

cd "$top"
for config in configs/*.yaml; do
  name=$(basename "$config" .yaml)
  program=rubsweep
  [[ $name != ring_* ]] || program=ringstab
  if ! "$before/apps/$program" --check "$config" >/dev/null 2>&1; then
    echo "$name: the build before does not know this configuration, left out"
    continue
  fi
  if [[ $program == ringstab ]]; then
    both "$name" ringstab "$config"
  else
    fewer=("${grid[@]}")
    # A list of values has no count; it is short anyway.
    ! grep -q 'values:' "$config" || fewer=()
    both "$name" rubsweep "$config" "${fewer[@]}"
    both "$name.trace" rubtrace "$config" --speed-hz 75 --whirl-ratio 0.4 --revolutions 200
  fi
done
exit "$differ"
