#!/usr/bin/env bash
# On a terminal progress shows itself. Skipped without `script` (Debian: bsdutils), which opens a pseudo terminal.
source "$(dirname "$0")/support.sh"
command -v script >/dev/null || { echo 'skipped: there is no program called script'; exit 77; }
one_cell 50 0.2

# at_terminal COMMAND: what the screen shows is in the file stdout.
at_terminal() {
  : >stderr
  script -qec "$1" /dev/null >stdout </dev/null || fail "$1: exit code $?"
}

run=$(printf '%q ' "$rubsweep" "$minimal" "${cell[@]}" --fresh)
at_terminal "$run"
expect_contains stdout '1/1 cells in '
at_terminal "$run --progress never"
grep -q 'cells' stdout && fail 'progress in spite of never'
at_terminal "$run --quiet"
expect_empty stdout
# Only stderr matters.
at_terminal "$run 2>progress"
expect_empty progress
expect_contains stdout 'map: '
