#!/usr/bin/env bash
# The map of minimal.yaml: what is in it, and that it is the same however it is made again.
source "$(dirname "$0")/support.sh"

expect_exit 0 "$minimal"
expect_files results minimal minimal/config.yaml minimal/map.csv
map=results/minimal/map.csv
expect_contains stdout "map: $map"
expect_contains stderr 'rubsweep: warning: in 2 of 24 cells the rotor moves farther than 10 clearances'
expect_whole_rows "$map"
expect_contains "$map" "# rubsweep $version"
expect_matches "$map" '^# digest [0-9a-f-]{36}$'
expect_matches "$map" '^# units: '

# One row per cell, speed fastest.
for whirl_ratio in 0.2 0.4 0.6 0.8; do
  for speed_hz in 50 70 90 110 130 150; do echo "$speed_hz,$whirl_ratio"; done
done >grid
cells "$map" speed_hz whirl_ratio | diff grid - || fail 'the rows are not the cells of the grid'
# The quiet motion in closed form: e = clearance x whirl ratio x |1 - q^2 + 2 i damping ratio q|, q = natural / speed.
closed_form='1e-3 * whirl_ratio * sqrt((1 - (30 / speed_hz) ** 2) ** 2 + (2 * 0.02 * 30 / speed_hz) ** 2)'
[[ $(count_rows "$map" "abs(eccentricity_m / ($closed_form) - 1) < 1e-12") == 24 ]] || fail 'eccentricity_m is not that of the whirl ratio'
[[ $(cells "$map" status | sort -u) == ok ]] || fail 'a cell is not ok'
# In the middle of the 1/2 tongue, and quiet above the rotor's own speed.
cells "$map" speed_hz whirl_ratio class order orbit whirl proof >labels
expect_matches labels '^90,0\.6,subharmonic,2,'
expect_matches labels '^50,0\.2,non_contact,,circle,forward,rest$'
# The summary counts every cell.
[[ $(awk '$3 == "%" { cells += $1 } END { print cells }' stdout) == 24 ]] || fail 'the summary does not add up to 24'

expect_exit 0 "$minimal" --print-config
expect_same stdout results/minimal/config.yaml

# The configuration beside the map makes it again, with --fresh over whatever an earlier run left behind.
mkdir again
echo 'an older file' | tee again/map.csv again/map.partial.csv >again/config.yaml
expect_exit 0 results/minimal/config.yaml --output again --fresh
expect_files again config.yaml map.csv
expect_same again/map.csv "$map"
expect_same again/config.yaml results/minimal/config.yaml

for threads in 1 2 3; do
  expect_exit 0 "$minimal" --threads "$threads" --output "threads_$threads"
  expect_same "threads_$threads/map.csv" "$map"
done
