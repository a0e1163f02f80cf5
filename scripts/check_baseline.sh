#!/usr/bin/env bash
# check_baseline.sh [REPEATS]: is the plain dopri5 that speed ratios are measured against compiled as well as a careful
# user would? Compiles its source by hand at -O2, at -O3 and for this machine's processor, runs all of them in turn with
# the one of the release build (REPEATS times, 15) and prints the median of the processor time of a turn, its ratio to
# the build's, and instructions where valgrind is installed. Exits 1 where the same flags by hand give a twentieth fewer
# instructions than the build.
set -euo pipefail
export LC_ALL=C.UTF-8
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
repeats=${1:-15}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --build "$top/build/release" --target plain_turns >/dev/null
cp "$top/build/release/studies/cost/plain_turns" "$work/build"
declare -A flags=([hand_O2]=-O2 [hand_O3]=-O3 [hand_native]='-O3 -march=native')
for name in "${!flags[@]}"; do
  # shellcheck disable=SC2086 # several flags
  ${CXX:-g++} -std=c++20 -DNDEBUG -ffp-contract=off ${flags[$name]} -I"$top/tests" -o "$work/$name" \
    "$top/studies/cost/plain_turns.cpp" "$top/tests/support/plain_dopri5.cpp"
done
names=(build hand_O2 hand_O3 hand_native)
for ((i = 0; i < repeats; ++i)); do
  for name in "${names[@]}"; do "$work/$name" 3000 | cut -d' ' -f1 >>"$work/$name.times"; done
done
median() { sort -g "$1" | sed -n "$(((repeats + 1) / 2))p"; }
# Valgrind does not know every instruction of a new processor.
instructions() {
  [[ $1 != hand_native ]] || return 0
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$work/$1" 300 2>&1 | sed -n 's/.*Collected : //p'
}
unit=$(median "$work/build.times")
for name in "${names[@]}"; do
  time=$(median "$work/$name.times")
  count=
  ! command -v valgrind >/dev/null || count=$(instructions "$name")
  echo "$name ${flags[$name]:-} : $time us per turn, $(awk "BEGIN { printf \"%.3f\", $time / $unit }") of the build's" \
    "${count:+, $count instructions for 300 turns}"
  [[ $name != build ]] || built=$count
  [[ $name != hand_O3 || -z $count ]] || by_hand=$count
done
[[ -z ${by_hand:-} ]] || ((100 * by_hand >= 95 * built))
