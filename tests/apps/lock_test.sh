#!/usr/bin/env bash
# Two runs on one directory: the second is told who is at work there, and touches nothing.
source "$(dirname "$0")/support.sh"
set -m
trap 'kill -KILL %% 2>/dev/null || true; rm -rf "$work"' EXIT
# One cell without a motion, at the undamped resonance, and one that takes as long as we like.
long=(--set rotor.damping_ratio=0 --set 'sweep={speed_hz: {values: [30, 70]}, whirl_ratio: {values: [0.2]}}' --set solver.method=adaptive --set solver.stepper=rosenbrock4
  --set solver.relative_tolerance=1e-14 --set solver.max_steps_per_revolution=1e9)

# start [ARGUMENT]...: runs it in the background, as $running, until it is at work in `busy`.
start() {
  "$rubsweep" "$minimal" "${long[@]}" --output busy "$@" >/dev/null 2>&1 </dev/null &
  running=$!
  until [[ -n $(find busy -name '*.journal' 2>/dev/null) ]]; do
    kill -0 "$running" 2>/dev/null || fail 'the program ended too early'
    sleep 0.02
  done
}
end() { kill -KILL "$running" && wait "$running" 2>/dev/null || true; }

start
cp busy/config.yaml before.yaml
for again in '' --fresh --merge '--shard 1/2' '--set rotor.mass_kg=0.9'; do
  # shellcheck disable=SC2086  # several arguments
  expect_exit 6 "$minimal" "${long[@]}" --output busy $again
  expect_empty stdout
  expect_matches stderr "^rubsweep: busy/map.lock is held by rubsweep, process $running on $(uname -n) since [0-9-]+ [0-9:]+ UTC$"
done
expect_same busy/config.yaml before.yaml
# Another directory is free, and so is this one as soon as the other process is dead.
expect_exit 0 "$minimal" --output free --set 'sweep={speed_hz: {values: [50]}, whirl_ratio: {values: [0.2]}}'
end
[[ -e busy/map.lock ]] || fail 'a killed process removed its lock'
expect_exit 0 "$minimal" --output busy --fresh --set 'sweep={speed_hz: {values: [50]}, whirl_ratio: {values: [0.2]}}'
expect_files busy config.yaml map.csv

# Shards work side by side, but each part only once, and nobody merges meanwhile.
rm -rf busy
start --shard 2/2
for again in '--shard 2/2' '--merge' ''; do
  # shellcheck disable=SC2086  # several arguments
  expect_exit 6 "$minimal" "${long[@]}" --output busy $again
  expect_matches stderr "busy/map.shard-2-of-2.lock is held by rubsweep --shard 2/2, process $running on"
done
# Nor does --fresh forget what a part at work has, not even one of another configuration.
expect_exit 6 "$minimal" "${long[@]}" --output busy --shard 1/2 --fresh --set rotor.mass_kg=0.9
expect_matches stderr "busy/map.shard-2-of-2.lock is held by rubsweep --shard 2/2, process $running on"
expect_exit 0 "$minimal" "${long[@]}" --output busy --shard 1/2
end
