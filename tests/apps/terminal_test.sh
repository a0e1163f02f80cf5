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

# trace_as_said MOTION: the command that the screen in the file stdout offers shows it.
trace_as_said() {
  local next
  next=$(tr -d '\r' <stdout | sed -n 's/^next: \(rubtrace .*\) --figure cell.png  # \(.*\)$/\1/p')
  [[ -n $next ]] || fail 'no next command'
  (
    PATH=$(dirname "$rubsweep"):$PATH
    eval "$next --output trace" >trace_stdout 2>stderr || fail "$next: exit code $?"
  )
  expect_contains trace_stdout "motion    $1"
}

run=$(printf '%q ' "$rubsweep" "$minimal" "${cell[@]}" --fresh)
at_terminal "$run"
expect_contains stdout '1/1 cells in '
at_terminal "$run --progress never"
grep -q 'cells' stdout && fail 'progress in spite of never'
at_terminal "$run --quiet"
expect_empty stdout
# Only stderr matters to the progress, only stdout to the map in characters.
at_terminal "$run 2>progress"
expect_empty progress
expect_contains stdout 'map: '
expect_matches stdout '^ +0\.2 \.'
at_terminal "$run >file"
! grep -q whirl_ratio file || fail 'the map in characters is in a file'
expect_contains file 'map: '
at_terminal "$run --progress never"
! grep -q whirl_ratio stdout || fail 'a map in characters in spite of never'

# The map, its summary, and commands that can be taken as they are.
expect_exit 0 "$minimal" --output 'a map' --quiet
at_terminal "$(printf '%q ' "$rubsweep" "$minimal" --output 'a map')"
tr -d '\r' <stdout >screen
[[ $(sed -n 1,6p screen | grep -c '^.\{15\}[.2-9]\{6\}$') == 4 ]] || fail "no map in characters: $(<screen)"
expect_contains screen '  2 subharmonic 1/2'
expect_matches screen '^ +5 +20\.8 %  subharmonic 1/2$'
expect_contains screen "next: rubreport 'a map'"
trace_as_said 'subharmonic 1/2'
# It names the keys of axes, too, without which there would be no rub here.
sed -e 's/force_n: 200/force_n: 10/' -e '/^sweep:/a\  x: {key: kick.force_n, values: [200]}' "$minimal" >keys.yaml
at_terminal "$(printf '%q ' "$rubsweep" keys.yaml --output keys)"
trace_as_said 'subharmonic 1/2'
# A map that is there is shown once, from the top of the screen.
at_terminal "$(printf '%q ' "$rubsweep" --watch 'a map')"
expect_contains stdout $'\x1b[H\x1b[J'
tr -d '\r' <stdout >screen
expect_contains screen '  2 subharmonic 1/2'
expect_contains screen 'a map: the map is there'
export COLORTERM=truecolor
at_terminal "$(printf '%q ' "$rubsweep" "$minimal" --output 'a map')"
expect_contains stdout $'\x1b[48;2;204;102;119m'
NO_COLOR=1 at_terminal "$(printf '%q ' "$rubsweep" "$minimal" --output 'a map')"
! grep -q $'\x1b\[48;2' stdout || fail 'colours in spite of NO_COLOR'
