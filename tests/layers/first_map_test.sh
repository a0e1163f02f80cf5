#!/usr/bin/env bash
# first_map_test.sh RUBSWEEP [NINJA BUILD]: the program that makes a map holds nothing of the folders that only other
# programs need, and with NINJA its target does not compile them either: the first map is there sooner.
set -euo pipefail
program=$1
folders='bench branch/orbits branch/continuation branch/curves branch/families config/recording config/ring'
folders+=' design fit identify line map/families numerics/spectral page ramp recording ring scope trace'
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
    "$(grep -E "^lib/rubsweep/($any_of)/CMakeFiles/" <<<"$objects" || true)"
fi
exit "$broken"
