#!/usr/bin/env bash
# A run that would be refused in the end is refused before anything is computed, and directories of results leave nothing empty
# behind, whatever way a run ends. Called with rubtrace, rubline, rubreport, rubbench and rubsweep-compare besides rubsweep.
source "$(dirname "$0")/support.sh"
rubtrace=$4 rubline=$5 rubreport=$6 rubbench=$7 compare=$8
set -m
trap 'kill -KILL %% 2>/dev/null || true; rm -rf "$work"' EXIT

# refuses CODE TEXT PROGRAM ARGUMENT...
refuses() {
  local code=0
  "${@:3}" >stdout 2>stderr </dev/null || code=$?
  [[ $code == "$1" ]] || fail "${*:3}: exit code $code, expected $1"
  expect_contains stderr "$2"
}

axes=("$minimal" --set 'sweep={speed_hz: {values: [60, 70]}, whirl_ratio: {values: [0.4, 0.6]}, x: {key: kick.force_n, values: [100, 200]}}')
refuses 2 'allowed: two axes with several values in a report' "$rubsweep" "${axes[@]}" --report --output three
expect_missing three
expect_exit 0 "${axes[@]}" --output three --quiet
refuses 2 'allowed: two axes with several values in a report' "$rubreport" three
one_cell 60 0.4
mkdir -p page/report.html
refuses 3 'cannot write page/report.html: Is a directory' "$rubsweep" "$minimal" "${cell[@]}" --report --output page
expect_missing page/map.csv
expect_exit 0 "$minimal" "${cell[@]}" --output whole --quiet
refuses 3 'cannot write nowhere/page.html: No such file or directory' "$rubreport" whole --output nowhere/page.html --progress always
grep -q 'cells in' stderr && fail 'the page was made first'
refuses 3 'cannot write nowhere/x.gp' "$compare" whole/map.csv whole/map.csv --figure nowhere/x.gp
expect_empty stdout
if command -v gnuplot >/dev/null; then
  mkdir figure.png
  for option in --figure; do
    refuses 3 'cannot write figure.png: Is a directory' "$rubsweep" "$minimal" "${cell[@]}" --output drawn $option figure.png
    refuses 3 'cannot write figure.png: Is a directory' "$rubtrace" "$minimal" --speed-hz 60 --whirl-ratio 0.4 --output drawn $option figure.png
  done
  refuses 2 'two axes with several values in a picture' "$rubsweep" "${axes[@]}" --output drawn --figure map.png
  expect_missing drawn
fi
mkdir -p taken/spectrum.csv taken_line/line.csv
refuses 3 'cannot write taken/spectrum.csv: Is a directory' "$rubtrace" "$minimal" --speed-hz 60 --whirl-ratio 0.4 --output taken
expect_files taken spectrum.csv
refuses 3 'cannot write taken_line/line.csv: Is a directory' "$rubline" "$minimal" --along speed_hz --from 60 --to 61 --count 2 --whirl-ratio 0.4 --output taken_line
expect_files taken_line line.csv
refuses 3 'file/results' "$rubtrace" "$minimal" --campbell 0:100 --output <(:)/file/results

# Speeds that no file would hold.
for option in '--campbell 0:1e12' '--campbell 0:9000' '--run-up 10:2e6:1e6 --eccentricity-m 1e-4'; do
  # shellcheck disable=SC2086  # several arguments
  refuses 1 'allowed: at most' "$rubtrace" "$minimal" $option --output none
done
refuses 1 'allowed: at most 1000000 Hz' "$rubtrace" "$top/configs/rotor_kit.yaml" --campbell 0:1e9 --output none
refuses 1 'allowed: at most 1000000 Hz' "$rubtrace" "$top/configs/rotor_kit.yaml" --speed-hz 1e7 --whirl-ratio 0.2 --output none
expect_missing none

# Ctrl-C says what is left, and that is no empty directory; nor is one left by a run that finds nothing to do.
long=("$minimal" --set solver.method=adaptive --set solver.stepper=rosenbrock4 --set solver.relative_tolerance=1e-14
  --set solver.max_steps_per_revolution=1e9 --set rotor.damping_ratio=0)
for program in "$rubtrace" "$rubbench"; do
  for signal in INT:130 TERM:143; do
    case $program in
      *rubtrace) place=(--speed-hz 70 --whirl-ratio 0.2 --revolutions 100000) ;;
      *) place=(--cell 70,0.2) ;;
    esac
    "$program" "${long[@]}" "${place[@]}" --output deep/er/out >stdout 2>stderr </dev/null &
    running=$!
    until [[ -d deep/er/out ]]; do sleep 0.02; done
    sleep 0.2
    kill -s "${signal%:*}" "$running"
    code=0
    wait "$running" || code=$?
    [[ $code == "${signal#*:}" ]] || fail "$program: exit code $code"
    [[ $(<stderr) == "${program##*/}: interrupted; nothing was written" ]] || fail 'another message'
    expect_missing deep
  done
done
