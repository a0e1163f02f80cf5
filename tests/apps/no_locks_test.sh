#!/usr/bin/env bash
# A file system without flock(2) has the locks of fcntl(2), and where there are none either the programs work and say so.
# Called with the library that takes them away, and rubdata.
source "$(dirname "$0")/support.sh"
library=$4 data=$5
set -m
trap 'kill -KILL %% 2>/dev/null || true; rm -rf "$work"' EXIT
long=("$minimal" --set rotor.damping_ratio=0 --set 'sweep={speed_hz: {values: [30, 70]}, whirl_ratio: {values: [0.2]}}'
  --set solver.method=adaptive --set solver.stepper=rosenbrock4 --set solver.relative_tolerance=1e-14 --set solver.max_steps_per_revolution=1e9)
export LD_PRELOAD=$library
expect_exit 0 "${quick[@]}" --output records --quiet
expect_empty stderr
expect_files records config.yaml map.csv
"$rubsweep" "${long[@]}" --output busy --threads 1 >/dev/null 2>&1 </dev/null &
running=$!
until [[ -e busy/map.journal ]]; do sleep 0.02; done
expect_exit 6 "${long[@]}" --output busy
expect_matches stderr "busy/map.lock is held by rubsweep, process $running on"
kill -KILL "$running" && wait "$running" 2>/dev/null || true
for i in 1 2; do expect_exit 0 "${quick[@]}" --output shards --shard $i/2 --quiet; done
expect_exit 0 "${quick[@]}" --output shards --merge --quiet
expect_same shards/map.csv records/map.csv

export NO_RECORD_LOCKS=1
expect_exit 0 "${quick[@]}" --output none --quiet
expect_contains stderr 'rubsweep: none: this file system has no locks: nothing keeps a second run away from it'
expect_files none config.yaml map.csv
expect_same none/map.csv records/map.csv
printf '%s\n' 'recordings: 1' 'recordings_per_machine: 1' 'machine: {mass_kg: 0.8, contact_radius_m: 0.0375}' \
  'measurement: {turns: 16, sampling_rate_hz: 2000, probes: 1}' 'output: {directory: set}' >study.yaml
"$data" study.yaml --quiet 2>stderr || fail 'no recording'
expect_contains stderr 'rubdata: set: this file system has no locks: nothing keeps a second run away from it'
