#!/usr/bin/env bash
# What the program prints when nobody sits at a terminal.
source "$(dirname "$0")/support.sh"
one_cell 50 0.2

expect_exit 0 "$minimal" "${cell[@]}"
expect_empty stderr
expect_exit 0 "$minimal" "${cell[@]}" --progress never
expect_empty stderr

expect_exit 0 "$minimal" "${cell[@]}" --progress always
expect_matches stderr $'^\r0/1 cells, 0%'
expect_matches stderr $'\r1/1 cells in 0:0[0-9]:[0-9]{2} *$'
expect_contains stdout 'map: '

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
