#!/usr/bin/env bash
# The command line: help, version, and what ends with 1 before any file is read.
source "$(dirname "$0")/support.sh"

expect_help threads init fresh shard merge report figure check explain print-config progress
expect_exit 0 --help
expect_matches stdout '^Examples:$'

# Every example is accepted; a long one goes on behind a backslash.
mapfile -t examples < <(sed ':a;/\\$/{N;s/ *\\\n */ /;ba}' stdout | sed -n 's,^  rubsweep configs/,,p')
((${#examples[@]} >= 3)) || fail 'fewer than three examples'
for example in "${examples[@]}"; do
  example=${example% --explain} example=${example% --export-matrices *}  # neither goes with --check
  eval "words=($example)"  # as a shell takes its quotes
  expect_exit 0 "$top/configs/${words[0]}" "${words[@]:1}" --check
done

# Short names of options.
expect_exit 0 -h
expect_matches stdout '^Examples:$'
expect_exit 0 "${quick[@]}" -j 1 -o short
expect_files short config.yaml map.csv
expect_exit 0 "${quick[@]}" -j2 -o short --quiet
expect_usage_error '--threads: allowed: a number from 0 to 1024' "$minimal" -j 100000
expect_usage_error "unrecognised option '-x'" "$minimal" -x

# Keys and schema are answers, alone.
expect_exit 0 --keys stops.0.friction
[[ $(head -n 1 stdout) == stops.N.friction ]] || fail 'keys of another section'
expect_matches stdout '^    >= 0; in s/m; default 0$'
expect_exit 0 --keys
expect_matches stdout '^rotor\.mass_kg$'
expect_exit 0 --schema
expect_contains stdout '"$schema":"http://json-schema.org/draft-07/schema#"'
expect_usage_error "--keys: there is no key 'stops.0.clearence_m' (did you mean" --keys stops.0.clearence_m
expect_usage_error '--keys: is asked for alone' --keys kick --check
expect_usage_error '--schema: is asked for alone, allowed: without CONFIG.yaml' "$minimal" --schema

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
