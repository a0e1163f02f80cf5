#!/usr/bin/env bash
# compare_compilers.sh [TOLERANCE]: builds rubsweep with clang (preset clang) beside the release build, computes the golden
# sub-map by either solver and the maps of the benchmark against one stop and two with both, and compares them: class and
# order on robust cells exactly, numbers to TOLERANCE (1e-4, the one of the golden maps). Exits with 5 where maps differ, with 77 where there is
# no clang or no release build.
set -euo pipefail
tolerance=${1:-1e-4}
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$top"
command -v clang++ >/dev/null || { echo 'compare_compilers.sh: no clang++; scripts/bootstrap.sh clang' >&2; exit 77; }
[[ -x build/release/apps/rubsweep-compare ]] || { echo 'compare_compilers.sh: no release build; scripts/test.sh' >&2; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{ cmake --preset clang && cmake --build --preset clang --target rubsweep; } >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }

differ=0
for config in tests/regression/benchmark_small.yaml{:exact,:adaptive} configs/{benchmark/one_side,benchmark/both_sides}.yaml:auto; do
  method=${config#*:} config=${config%:*}
  map=$(basename "$config" .yaml)_$method
  for build in release clang; do
    "build/$build/apps/rubsweep" "$config" --quiet --set response.robustness=on --set solver.method="$method" \
      --output "$work/$build/$map" || (($? == 4))
  done
  echo "== $map, gcc against clang"
  identical=$(diff <(grep -v '^#' "$work/release/$map/map.csv") <(grep -v '^#' "$work/clang/$map/map.csv") | grep -c '^<' || true)
  echo "$(($(grep -vc '^#' "$work/release/$map/map.csv") - 1)) cells, $identical rows differ in some digit"
  build/release/apps/rubsweep-compare "$work/release/$map/map.csv" "$work/clang/$map/map.csv" --tolerance "$tolerance" || differ=$?
done
exit "$differ"
