#!/usr/bin/env bash
# first_map_test.sh RUBSWEEP [NINJA BUILD]: the program that makes a map holds nothing of the storeys that only other
# programs need, and with NINJA its target does not compile them either: the first map is there sooner.
set -euo pipefail
program=$1
# Namespaces of these storeys, and what of `core` only they need.
folders='numerics/spectral bench branch design linear line page ramp trace dataset diagnose fit recording scope ring'
folders+=' config/dataset config/recording config/ring'
any_of=${folders// /|}

# refuse WHAT LINE...: complains of the lines, where there are any.
broken=0
refuse() {
  local what=$1 lines=$2
  [[ -n $lines ]] || return 0
  printf '%s:\n%s\n' "$what" "$lines"
  broken=1
}

symbols=$(nm -C "$program")
grep -q 'rubsweep::sweep::' <<<"$symbols" || { echo "$program: nm shows none of its symbols"; exit 1; }
refuse "$program has symbols of other programs" \
  "$(grep -E "rubsweep::(${any_of//\//::})::" <<<"$symbols" | cut -c1-200 | head -n 20 || true)"

if [[ $# -gt 1 ]]; then
  objects=$("$2" -C "$3" -t inputs "$(realpath --relative-to "$3" "$program")" | grep '\.o$')
  grep -q '^lib/rubsweep/maps/sweep/' <<<"$objects" || { echo "$program: ninja shows none of its objects"; exit 1; }
  refuse "what $program is built from holds objects of other programs" \
    "$(grep -E '^lib/rubsweep/(core/numerics/spectral|analysis|measurement|ring)/|^apps/bench/' <<<"$objects" || true)"
fi
exit "$broken"
