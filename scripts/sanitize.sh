#!/usr/bin/env bash
# sanitize.sh [--minutes N]: the unit tests under the address and undefined-behaviour sanitizers, compiled by clang.
# --minutes N: begins with the folders that the last commit changes, goes on to others from one that the commit chooses, so
# that in time all have their turn, builds for N minutes at most (and one test in any case), and names what was left out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/sanitize

minutes=1000
while (($#)); do
  case $1 in
    --minutes) minutes=${2:?--minutes needs a number}; shift 2 ;;
    -h | --help) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
    *) echo "sanitize.sh: $1 is no option, allowed: --minutes N" >&2; exit 2 ;;
  esac
done
deadline=$((EPOCHSECONDS + 60 * minutes))

scripts/bootstrap.sh clang lld libclang-rt-14-dev
cmake --preset sanitize
mapfile -t targets < <(ninja -C "$build" -t query tests/unit_tests | grep -oE '[a-z_]+_test$' | sort -u)
((${#targets[@]})) || { echo "sanitize.sh: $build has no target unit_tests" >&2; exit 1; }

# tests_of FILE: the target that tests the file's folder, or the nearest folder above it that has tests.
tests_of() {
  local folder=${1%/*} target
  folder=${folder#lib/rubsweep/} folder=${folder#tests/}
  # Targets are named without the storey.
  [[ $folder == ring ]] || folder=${folder#*/}
  while true; do
    target=${folder//\//_}_test
    if [[ " ${targets[*]} " == *" $target "* ]]; then
      echo "$target"
      return
    fi
    [[ $folder == */* ]] || return 0
    folder=${folder%/*}
  done
}

in_turn() {
  git diff --name-only --diff-filter=d HEAD^ HEAD -- lib tests 2>/dev/null |
    while IFS= read -r file; do tests_of "$file"; done
  local first=$((16#$(git rev-parse --short=6 HEAD | head -c 6) % ${#targets[@]}))
  printf '%s\n' "${targets[@]:first}" "${targets[@]:0:first}"
}

mapfile -t targets < <(in_turn | awk '!seen[$0]++')
left_out=() built=
for target in "${targets[@]}"; do
  left=$((deadline - EPOCHSECONDS)) result=124
  if ((left > 0)); then
    result=0
    timeout --signal=INT "$left" cmake --build --preset sanitize --target "$target" || result=$?
  fi
  case $result in
    0) built=$target ;;
    124) left_out+=("$target") ;;
    *) exit 1 ;;
  esac
done

# A slow machine tests something, too: what takes the fewest steps from here.
if [[ ! $built ]]; then
  built=$(for target in "${targets[@]}"; do echo "$(ninja -C "$build" -n "$target" | wc -l) $target"; done | sort -n | sed -n '1s/.* //p')
  cmake --build --preset sanitize --target "$built"
  mapfile -t left_out < <(printf '%s\n' "${left_out[@]}" | grep -vx "$built")
fi
((${#left_out[@]} == 0)) || echo "Left out, the time is up: ${left_out[*]}"
# Tests that are not compiled need no sanitizer.
ctest --preset sanitize -L unit -E '_NOT_BUILT$|^scripts[.]' --parallel "$(($(nproc) + 1))"
