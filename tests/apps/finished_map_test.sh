#!/usr/bin/env bash
# A finished map is never overwritten or removed without --fresh: one of another configuration is refused, one of the same
# configuration is all there is to do.
source "$(dirname "$0")/support.sh"
one_cell 50 0.2
cell=("$minimal" "${cell[@]}")
changed=(--set rotor.mass_kg=0.9 --set solver.relative_tolerance=1e-7)
digest_of() { sed -n 's/^# digest //p' "$1/map.csv"; }

expect_exit 0 "${cell[@]}" --output map
expect_exit 0 "${cell[@]}" "${changed[@]}" --output elsewhere
there=$(digest_of map) here=$(digest_of elsewhere)
cp -r map before

# expect_as_before: the directory holds what it held.
expect_as_before() {
  expect_same map/map.csv before/map.csv
  expect_same map/config.yaml before/config.yaml
  expect_files map config.yaml map.csv
}

# A map of another configuration.
for division in '' --merge '--shard 1/2'; do
  # shellcheck disable=SC2086  # several arguments
  expect_exit 2 "${cell[@]}" "${changed[@]}" --output map $division
  expect_empty stdout
  cat >expected <<TEXT
map/map.csv: is a finished map of another configuration (digest $there, this one has $here):
  rotor.mass_kg: 0.8 there, 0.9 here
  solver.relative_tolerance: 1e-08 there, 1e-07 here
allowed: the same again, another --output, or --fresh to replace it
TEXT
  expect_same stderr expected
  expect_as_before
done
# The keys are known from config.yaml alone.
mv map/config.yaml kept.yaml
expect_exit 2 "${cell[@]}" "${changed[@]}" --output map
expect_contains stderr 'which keys differ is not known: map/config.yaml cannot be read'
cp elsewhere/config.yaml map/config.yaml
expect_exit 2 "${cell[@]}" "${changed[@]}" --output map
expect_contains stderr 'which keys differ is not known: map/config.yaml is not the one of the map'
mv kept.yaml map/config.yaml
expect_as_before

# A map of this one: said to be there, with the exit code that it deserves.
touch -d '2001-01-01' map/map.csv
for division in '' --merge '--shard 1/2'; do
  # shellcheck disable=SC2086
  expect_exit 0 "${cell[@]}" --output map $division
  expect_matches stdout '^ +1 +100.0 %  non_contact$'
  expect_contains stdout 'map: map/map.csv'
  [[ $(<stderr) == 'rubsweep: the map is there, nothing is left to do; --fresh computes it anew' ]] || fail 'another message'
  expect_as_before
done
[[ map/map.csv -ot before/map.csv ]] || fail 'the map was written again'
expect_exit 0 "${cell[@]}" --output map --quiet
expect_empty stdout
expect_empty stderr
expect_exit 0 "${cell[@]}" --output map --fresh
expect_empty stderr
[[ map/map.csv -ot before/map.csv ]] && fail 'the map was not computed anew'
expect_as_before
cp -r map failed
sed -i 's/,non_contact,\(.*\),ok,kick,/,failed,\1,step_limit,kick,/' failed/map.csv
reseal failed/map.csv
expect_exit 4 "${cell[@]}" --output failed
expect_contains stdout 'status step_limit'

# No whole map: cut, or not one at all.
sed -i '$d' failed/map.csv
reseal failed/map.csv
expect_exit 2 "${cell[@]}" --output failed
expect_contains stderr 'failed/map.csv: holds 0 cells of this configuration, which has 1: there is no row of speed_hz 50, whirl_ratio 0.2'
echo precious >failed/map.csv
expect_exit 2 "${cell[@]}" --output failed
expect_contains stderr 'failed/map.csv: is no map of this program'
[[ $(<failed/map.csv) == precious ]] || fail 'the file in the way was changed'

# --fresh replaces.
expect_exit 0 "${cell[@]}" "${changed[@]}" --output map --fresh
expect_same map/map.csv elsewhere/map.csv
expect_contains map/config.yaml 'mass_kg: 0.9'
