#!/usr/bin/env bash
# count_operations.sh: instructions, multiplications, additions, divisions and square roots in one turn of the exact
# solver (set A, 75 Hz, whirl ratio 0.4), and which part of it takes the instructions, by valgrind's callgrind: what 3000
# turns take more than 1000. Packed instructions count twice; those of libm count as instructions only. Needs valgrind,
# binutils and the release build.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")
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
for turns in 1000 3000; do
  callgrind_annotate --inclusive=yes --threshold=100 "$work/$turns" 2>/dev/null >"$work/functions_$turns"
done
python3 "$here/analysis/callgrind_operations.py" "$work/instructions" "$work/1000" "$work/functions_1000" \
  "$work/3000" "$work/functions_3000" 2000
