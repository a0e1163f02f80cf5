#!/usr/bin/env bash
# Files that cannot be read or written end a program with 3 and their name; no half a file stands under a result's name.
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

# Files that could never be written in the end are refused at once, and so is a pipe that nobody may ever read.
mkdir -p no_map/map.csv
expect_io_error no_map/map.csv "$minimal" "${cell[@]}" --output no_map
expect_contains stderr 'is not a regular file'
expect_files no_map map.csv
for name in map.journal map.rank-1.journal map.partial.csv map.csv config.yaml; do
  mkdir pipe && mkfifo "pipe/$name"
  expect_io_error "pipe/$name" "$minimal" "${cell[@]}" --output pipe
  expect_files pipe "$name"
  rm -r pipe
done
# The map.partial.csv of an earlier run does not stay.
mkdir stale
echo 'an older row' >stale/map.partial.csv
expect_exit 0 "$minimal" "${cell[@]}" --output stale
expect_files stale config.yaml map.csv

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

# Descriptors 0 to 2 that are closed are not taken by data files: what is printed goes nowhere else.
for closed in '<&- 2>&-' '<&- >&- 2>&-' '2>&-'; do
  rm -rf closed
  eval '"$rubsweep" "$minimal" --output closed --shard 1/2 --progress always '"$closed" >stdout || [[ $closed == *'>&- 2'* ]] ||
    fail "closed descriptors $closed: exit code $?"
  grep -qa 'records$' closed/map.shard-1-of-2.journal || fail 'no journal'
  if grep -qaE 'cells( |,)' closed/map.*; then fail "$closed: what is printed went into a data file"; fi
done
code=0
"$rubsweep" "$minimal" --print-config >&- 2>stderr || code=$?
[[ $code == 3 ]] || fail "a closed standard output: exit code $code"

# Whoever reads the progress may go: the sweep runs on. A reader of the result who goes ends the program quietly.
("$rubsweep" "$minimal" --output unread --progress always 2>&1 || true) | head -c 1 >/dev/null
expect_exit 0 "$minimal" --output unread_whole
expect_same unread/map.csv unread_whole/map.csv
{ { code=0; "$rubsweep" "$minimal" --explain 2>stderr || code=$?; echo $code >code; } | true; } || true
[[ $(<code) == 0 || $(<code) == 141 ]] || fail "a reader who is gone: exit code $(<code)"
expect_empty stderr

# A finished map stays when a run on another configuration is refused, whatever would have become of that run.
expect_exit 0 "$minimal" "${cell[@]}" --output reused
cp -r reused before
(
  ulimit -f 4
  expect_exit 2 "$minimal" --output reused
)
expect_same reused/map.csv before/map.csv
expect_same reused/config.yaml before/config.yaml

# A user's own file is not replaced by the configuration as programs write it; a file that they wrote is.
mkdir own
printf '# mine\n' | cat - "$minimal" >own/config.yaml
cp own/config.yaml mine.yaml
expect_exit 2 own/config.yaml "${cell[@]}" --output own
expect_contains stderr 'own/config.yaml: would be replaced by the config.yaml of the results'
expect_same own/config.yaml mine.yaml
expect_files own config.yaml
expect_exit 0 mine.yaml "${cell[@]}" --output of_mine --quiet
expect_exit 0 of_mine/config.yaml --output of_mine --quiet

# The directory of a map is its own.
cp of_mine/config.yaml before.yaml
"${rubsweep%/*}/rubtrace" "$minimal" --speed-hz 90 --whirl-ratio 0.6 --output of_mine 2>stderr && fail 'a trace in a map'
expect_contains stderr 'of_mine: holds a map'
expect_same of_mine/config.yaml before.yaml
expect_exit 0 mine.yaml "${cell[@]}" --output of_part --shard 1/2 --quiet
"${rubsweep%/*}/rubline" "$minimal" --along kick.force_n --from 1 --to 2 --count 2 --speed-hz 90 --whirl-ratio 0.6 --output of_part 2>stderr &&
  fail 'a line in a part of a map'
expect_contains stderr 'of_part: holds a map'
"${rubsweep%/*}/rubreport" of_mine --output of_mine/map.csv 2>stderr && fail 'a report over its map'
expect_contains stderr '--output of_mine/map.csv: is read for the report'
"${rubsweep%/*}/rubreport" of_mine --output /dev/null 2>stderr && fail 'a report over a device'
expect_contains stderr '/dev/null: is not a regular file'
[[ -c /dev/null ]] || fail 'a device was replaced'
