#!/usr/bin/env bash
# The command line: help, version, and what ends with 1 before any file is read.
source "$(dirname "$0")/support.sh"

expect_help threads fresh shard merge report figure check explain print-config progress
expect_exit 0 --help
expect_matches stdout '^Examples:$'

# Every example is accepted; a long one goes on behind a backslash.
mapfile -t examples < <(sed ':a;/\\$/{N;s/ *\\\n */ /;ba}' stdout | sed -n 's,^  rubsweep configs/,,p')
((${#examples[@]} >= 3)) || fail 'fewer than three examples'
for example in "${examples[@]}"; do
  eval "words=(${example% --explain})"  # as a shell takes its quotes
  expect_exit 0 "$top/configs/${words[0]}" "${words[@]:1}" --check
done

expect_usage_error 'a configuration file is needed'
expect_usage_error 'a configuration file is needed' --quiet
expect_usage_error "unrecognised option '--nope'" "$minimal" --nope
expect_usage_error "unrecognised option '--thread' (did you mean '--threads'?)" "$minimal" --thread 1
expect_usage_error 'too many positional options' "$minimal" "$minimal"
expect_usage_error '--threads: allowed: a number from 0 to 1024' "$minimal" --threads -1
expect_usage_error '--threads: allowed: a number from 0 to 1024' "$minimal" --threads 100000
expect_usage_error '--output: allowed: the name of a directory' "$minimal" --output ''
expect_usage_error "the argument ('two') for option '--threads' is invalid" "$minimal" --threads two
expect_usage_error "--progress: 'maybe' is not allowed, allowed: auto, always, never" "$minimal" --progress maybe
expect_usage_error "the required argument for option '--set' is missing" "$minimal" --set
for shard in 0/2 3/2 1 1/ /2 1/2/3 -1/2 1/10001 a/b ''; do
  expect_usage_error "--shard: '$shard' is not allowed, allowed: I/N with 1 <= I <= N <= 10000" "$minimal" --shard "$shard"
done
expect_usage_error '--merge excludes --fresh and --shard' "$minimal" --merge --fresh
expect_usage_error '--merge excludes --fresh and --shard' "$minimal" --shard 1/2 --merge
for two in '--check --explain' '--explain --print-config' '--print-config --check'; do
  # shellcheck disable=SC2086  # two arguments
  expect_usage_error '--check, --explain and --print-config exclude each other' "$minimal" $two
done
# Usage comes before the file.
expect_usage_error '--progress' no_such_file.yaml --progress maybe
