#!/usr/bin/env bash
# Whichever allocation fails, of the program or of a library: exit code 70 with a message, and nothing that was finished is
# lost. Called with the library that lets one fail, rubtrace, rubline and how many of the allocations are tried: `all`, or so
# many spread over the run.
source "$(dirname "$0")/support.sh"
library=$4 rubtrace=$5 rubline=$6 tried=$7
small=("$minimal" --set 'sweep={speed_hz: {values: [60, 90]}, whirl_ratio: {values: [0.4, 0.6]}}' --quiet)

# count_of PROGRAM ARGUMENT...: its allocations.
count_of() {
  COUNT_ALLOCATIONS=count LD_PRELOAD=$library "$@" >stdout 2>stderr </dev/null || fail "$*: failed"
  cat count
}

# numbers COUNT: those that are to fail.
numbers() {
  if [[ $tried == all ]]; then seq "$1"; else seq 1 "$(($1 / tried + 1))" "$1"; fi
}

# without NUMBER PROGRAM ARGUMENT...: the allocation of this number fails; sets `code`. What does not need it goes on.
without() {
  code=0
  FAIL_ALLOCATION=$1 LD_PRELOAD=$library "${@:2}" >stdout 2>stderr </dev/null || code=$?
  [[ $code == 0 || $code == 70 ]] || fail "allocation $1 of ${*:2}: exit code $code"
  [[ $code == 0 || -s stderr ]] || fail "allocation $1 of ${*:2}: no message"
  [[ $code == 0 ]] || ((++faults))
}

# A sweep: whatever is finished stays, and the same command makes the same map.
expect_exit 0 "${small[@]}" --output whole --threads 1
faults=0
for number in $(numbers "$(count_of "$rubsweep" "${small[@]}" --output counted --threads 1)"); do
  rm -rf map
  without "$number" "$rubsweep" "${small[@]}" --output map --threads 1
  if [[ $code == 70 ]]; then
    finished=$(cat map/map.journal 2>/dev/null | grep -c ',ok,kick,' || true)
    expect_exit 0 "${small[@]:0:3}" --output map --threads 1
    [[ $finished == 0 ]] || { expect_contains stderr "$finished of 4 cells were finished before" && touch kept; }
  fi
  expect_same map/map.csv whole/map.csv
done
((faults > 0)) || fail 'no allocation that failed mattered'
[[ -e kept ]] || fail 'no fault came late enough to keep a cell'

# All that follow fail as well, the message's own among them; and with threads.
for number in 100 1000 5000; do
  rm -rf map
  FAIL_ALL=1 without "$number" "$rubsweep" "${small[@]}" --output map --threads 1
  [[ $code == 70 ]] || fail "without memory from allocation $number on: exit code $code"
  rm -rf map
  without "$number" "$rubsweep" "${small[@]}" --output map --threads 2
  expect_exit 0 "${small[@]}" --output map
  expect_same map/map.csv whole/map.csv
done

# Programs that keep nothing: no file that looks whole and is not.
trace=("$rubtrace" "$minimal" --speed-hz 90 --whirl-ratio 0.6 --revolutions 40 --quiet)
line=("$rubline" "$minimal" --along speed_hz --from 60 --to 90 --count 2 --whirl-ratio 0.4 --quiet --threads 1)
for program in trace line; do
  declare -n command=$program
  "${command[@]}" --output "$program"
  faults=0
  for number in $(numbers "$(count_of "${command[@]}" --output "counted_$program")"); do
    rm -rf out
    without "$number" "${command[@]}" --output out
    for file in out/*; do
      [[ ! -e $file ]] || expect_same "$file" "$program/${file##*/}"
    done
  done
  ((faults > 0)) || fail "$program: no allocation that failed mattered"
done
(
  ulimit -v 20000
  code=0
  "${line[@]}" --output limited >stdout 2>stderr || code=$?
  # 127: not even the loader had room.
  [[ $code == 70 || $code == 127 ]] || fail "under a limit: exit code $code"
)
