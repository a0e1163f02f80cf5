#!/usr/bin/env bash
# Output of the program when nobody sits at a terminal.
source "$(dirname "$0")/support.sh"
one_cell 50 0.2
cell+=(--fresh) # the map is there after the first time

expect_exit 0 "$minimal" "${cell[@]}"
expect_empty stderr
expect_exit 0 "$minimal" "${cell[@]}" --progress never
expect_empty stderr

expect_exit 0 "$minimal" "${cell[@]}" --progress always
# Lines, as nothing is rewritten in a file.
expect_matches stderr '^0/1 cells, 0%$'
expect_matches stderr '^1 cells on [0-9]+ threads: up to [0-9.]+ MB of memory, 0.1 MB of disk$'
expect_matches stderr '^1/1 cells in 0:0[0-9]:[0-9]{2}$'
grep -q $'\r' stderr && fail 'one line for all'
expect_contains stdout 'map: '

# A map on which nothing can rub says why: before it starts, in the explanation and in its summary.
sed '/^kick:/d' "$minimal" >no_kick.yaml
expect_exit 0 no_kick.yaml "${cell[@]}" --progress always --output no_kick
expect_contains stderr 'no kick: the cells whose quiet whirl leaves a clearance'
expect_contains stdout 'no wall was ever touched: there is no kick'
expect_exit 0 no_kick.yaml "${cell[@]}" --explain
expect_contains stdout 'no kick: the cells whose quiet whirl leaves a clearance'
weak=("$minimal" "${cell[@]}" --set kick.force_n=1)
expect_exit 0 "${weak[@]}" --progress always --output weak
expect_contains stderr 'weak kick: 1 N for 0.005 s reach no wall'
expect_contains stdout 'no wall was ever touched: the kick is too weak'
expect_exit 0 "${weak[@]}" --explain
expect_contains stdout 'weak kick: 1 N for 0.005 s reach no wall'

# A long one says beforehand how long, by cells that are part of it.
expect_exit 0 "${quick[@]}" --set sweep.speed_hz.count=125 --progress always --threads 2 --output long
expect_matches stderr '^about 0:0[0-9]:[0-9]{2} by 32 cells spread over the map *$'
expect_exit 0 "${quick[@]}" --set sweep.speed_hz.count=125 --threads 1 --output long_too
expect_same long/map.csv long_too/map.csv
# A sweep that does not fit is refused before anything is written.
expect_exit 2 "$minimal" --threads 1024 --output large \
  --set 'response={window_revolutions: 4096, samples_per_revolution: 4096, max_revolutions: 10000}'
expect_matches stderr '^24 cells on 1024 threads: up to [0-9.e+]+ GB of memory, 0.1 MB of disk, this machine has [0-9]+ MB, allowed: fewer'
expect_missing large

for progress in auto always never; do
  expect_exit 0 "$minimal" "${cell[@]}" --quiet --progress "$progress"
  expect_empty stdout
  expect_empty stderr
done
expect_exit 0 "$minimal" --quiet --check
expect_empty stdout
# Errors are not quiet.
expect_exit 3 no_such_file.yaml --quiet
expect_contains stderr no_such_file.yaml
