#!/usr/bin/env bash
# SIGINT and SIGTERM end a sweep soon, with the running cells where these end soon; what is finished stays, and can be seen in map.partial.csv.
source "$(dirname "$0")/support.sh"
# With job control, background jobs do not ignore SIGINT.
set -m
trap 'kill -KILL %% 2>/dev/null || true; rm -rf "$work"' EXIT

# start DIRECTORY CELLS ARGUMENT...: runs the program in the background, as $running, until CELLS cells are finished.
start() {
  local partial=$1/map.partial.csv cells=$2
  "$rubsweep" "${@:3}" --threads 2 --output "$1" >stdout 2>stderr </dev/null &
  running=$!
  until [[ -e $partial ]] && (($(rows "$partial" | wc -l) >= cells)); do
    kill -0 "$running" 2>/dev/null || fail "the program ended before $cells cells were finished"
    sleep 0.02
  done
}

# expect_end CODE: waits for $running.
expect_end() {
  local code=0
  wait "$running" || code=$?
  [[ $code == "$1" ]] || fail "exit code $code, expected $1"
}

# interrupt SIGNAL CODE
interrupt() {
  start "$1" 3 "$top/configs/benchmark/one_side.yaml" --set solver.method=adaptive
  kill -s "$1" "$running"
  expect_end "$2"
  expect_empty stdout
  expect_files "$1" config.yaml map.journal map.partial.csv
  local finished
  finished=$(rows "$1/map.partial.csv" | wc -l)
  [[ $(<stderr) == "rubsweep: interrupted; $finished of 1320 cells are finished, the same command computes the others" ]] ||
    fail 'another message'
  expect_whole_rows "$1/map.partial.csv"
  (($(rows "$1/map.partial.csv" | wc -l) < 1320)) || fail 'the sweep was not interrupted'
}

interrupt INT 130
interrupt TERM 143

# A finished cell is final: the last cell alone gives the same row.
rows TERM/map.partial.csv | tail -n 1 >last
IFS=, read -r speed_hz whirl_ratio _ <last
one_cell "$speed_hz" "$whirl_ratio"
expect_exit 0 "$top/configs/benchmark/one_side.yaml" "${cell[@]}" --set solver.method=adaptive --output alone
rows alone/map.csv >row
expect_same row last

# The first cell has no motion to integrate, the second very long. It is given up, and nothing of it is kept; a second signal
# would end the program at once.
long=(--set rotor.damping_ratio=0 --set 'sweep={speed_hz: {values: [30, 70]}, whirl_ratio: {values: [0.2]}}'
  --set solver.method=adaptive --set solver.stepper=rosenbrock4 --set solver.relative_tolerance=1e-14 --set solver.max_steps_per_revolution=1e9)
for signal in INT:130 TERM:143; do
  start "long_$signal" 1 "$minimal" "${long[@]}"
  kill -s "${signal%:*}" "$running"
  expect_end "${signal#*:}"
  [[ $(<stderr) == 'rubsweep: interrupted; 1 of 2 cells are finished, the same command computes the others' ]] ||
    fail 'another message'
  expect_whole_rows "long_$signal/map.partial.csv"
  [[ $(rows "long_$signal/map.partial.csv" | wc -l) == 1 && $(grep -c ',[a-z_]*$' "long_$signal/map.journal") == 1 ]] ||
    fail 'the cell that was given up was kept'
  expect_files "long_$signal" config.yaml map.journal map.partial.csv
done

# A signal that was ignored from the start, as by nohup, stays ignored.
(
  trap '' INT
  exec "$rubsweep" "$minimal" "${long[@]}" --threads 2 --output ignored >stdout 2>stderr </dev/null
) &
running=$!
until [[ -e ignored/map.partial.csv ]] && (($(rows ignored/map.partial.csv | wc -l) >= 1)); do sleep 0.02; done
kill -s INT "$running"
sleep 1.5
kill -0 "$running" || fail 'an ignored signal ended the sweep'
kill -s TERM "$running"
expect_end 143
