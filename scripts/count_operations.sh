#!/usr/bin/env bash
# count_operations.sh: instructions, multiplications, additions, divisions and square roots in one turn of the exact
# solver (set A, 75 Hz, whirl ratio 0.4), and which part of it takes the instructions, by valgrind's callgrind: what 3000
# turns take more than 1000. Packed instructions count twice; those of libm count as instructions only. Needs valgrind,
# binutils and the release build.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$top/build/release/studies/cost/exact_turns
[[ -x $program ]] || { echo "count_operations.sh: no $program; run scripts/test.sh" >&2; exit 1; }
command -v valgrind >/dev/null || { echo 'count_operations.sh: needs valgrind (Debian package: valgrind)' >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

objdump -d --no-show-raw-insn "$program" | sed -n 's/^ *\([0-9a-f]*\):\t\([a-z0-9]*\).*/0x\1 \2/p' >"$work/instructions"
for turns in 1000 3000; do
  valgrind --tool=callgrind --dump-instr=yes --compress-pos=no --compress-strings=no \
    --callgrind-out-file="$work/$turns" "$program" "$turns" 2>/dev/null
done
awk '
  FILENAME ~ /instructions$/ { mnemonic[$1] = $2; next }
  FNR == 1 { sign = FILENAME ~ /1000$/ ? -1 : 1; inclusive = 0 }
  /^ob=/ { own = /exact_turns$/ }
  /^calls=/ { inclusive = 1; next }  # the line after it repeats what the function called has taken
  /^0x/ {
    if (inclusive) { inclusive = 0; next }
    share = sign * $3 / 2000
    total += share
    name = own ? mnemonic[$1] : ""
    lanes = name ~ /pd$/ ? 2 : 1
    if (name ~ /^mul[ps]d$/) multiplications += lanes * share
    if (name ~ /^(add|sub)[ps]d$/) additions += lanes * share
    if (name ~ /^div[ps]d$/) divisions += lanes * share
    if (name ~ /^sqrt[ps]d$/) roots += lanes * share
  }
  END {
    printf "per turn: %.0f instructions, %.0f multiplications, %.0f additions, %.0f divisions, %.0f square roots\n",
           total, multiplications, additions, divisions, roots
  }' "$work/instructions" "$work/1000" "$work/3000"

for turns in 1000 3000; do
  callgrind_annotate --inclusive=yes --threshold=100 "$work/$turns" 2>/dev/null >"$work/functions_$turns"
done
awk '
  { gsub(",", "", $1); sign = FILENAME ~ /1000$/ ? -1 : 1 }
  /ExactRun<4>::go_on\(/ { inside += sign * $1 }
  /ExactMotion<4>::land\(/ { landings += sign * $1 }
  /ExactRun<4>::switch_mode\(/ { switches += sign * $1 }
  END {
    printf "of the instructions: %.0f in steps, %.0f in landings, %.0f in switches\n",
           (inside - landings - switches) / 2000, landings / 2000, switches / 2000
  }' "$work/functions_1000" "$work/functions_3000"
