#!/usr/bin/env bash
# What cannot be read or written ends with 3, names the path, and never leaves half a file under a result's name.
source "$(dirname "$0")/support.sh"
one_cell 50 0.2

# expect_io_error PATH ARGUMENT...: the message names PATH.
expect_io_error() {
  local path=$1
  shift
  expect_exit 3 "$@"
  expect_empty stdout
  expect_matches stderr "^rubsweep: .*$path"
}

expect_io_error no_such_file.yaml no_such_file.yaml
expect_contains stderr 'No such file or directory'
mkdir folder.yaml
expect_io_error folder.yaml folder.yaml --check

# Nowhere to write.
echo precious >file
expect_io_error file "$minimal" --output file
expect_io_error file/below "$minimal" --output file/below
[[ $(<file) == precious ]] || fail 'the file in the way was changed'
expect_io_error /proc/rubsweep "$minimal" --output /proc/rubsweep

# config.yaml cannot be replaced: nothing is begun.
mkdir -p no_config/config.yaml
expect_io_error no_config/config.yaml "$minimal" "${cell[@]}" --output no_config
expect_files no_config config.yaml

# map.csv cannot be replaced: the finished cells stay, the map.partial.csv of an earlier run does not.
mkdir -p no_map/map.csv
echo 'an older row' >no_map/map.partial.csv
expect_io_error no_map/map.csv "$minimal" "${cell[@]}" --output no_map
expect_files no_map config.yaml map.csv map.journal map.partial.csv
expect_whole_rows no_map/map.partial.csv
[[ $(rows no_map/map.partial.csv) == 50,0.2,* ]] || fail 'the finished cell is not in map.partial.csv'

# The disk is full after a few kilobytes: more than config.yaml needs, less than the map.
(
  ulimit -f 4
  expect_io_error full/map.journal "$minimal" --output full
)
expect_contains stderr 'File too large'
expect_files full config.yaml map.journal map.partial.csv

# A device that is full: the program says so where it can, and never dies of it.
for action in --print-config --explain --help; do
  "$rubsweep" "$minimal" "$action" >/dev/full 2>stderr </dev/null && fail "$action into a full device ended with 0" || [[ $? == 3 ]] ||
    fail "$action into a full device did not end with 3"
done
"$rubsweep" no_such_file.yaml 2>/dev/full </dev/null && fail 'no error' || [[ $? == 3 ]] || fail 'a full stderr changed the exit code'
"$rubsweep" "$minimal" "${cell[@]}" --output gone --progress always --quiet 2>/dev/full </dev/null ||
  fail 'a full stderr ended a run'

# A map of another study does not stay beside the new configuration; one of the same study does.
expect_exit 0 "$minimal" "${cell[@]}" --output reused
cp reused/map.csv before.csv
(
  ulimit -f 4
  expect_exit 3 "$minimal" --output reused
)
[[ ! -e reused/map.csv ]] || fail 'the map of another study stayed'
