#!/usr/bin/env bash
# Maps over any numbers of the configuration: their cells are those that --set gives, and threads, shards, resuming,
# comparing, pictures and reports take them like any other map.
source "$(dirname "$0")/support.sh"

axes=("$minimal" --set 'sweep={speed_hz: {values: [75]}, whirl_ratio: {values: [0.4]},
  x: {key: kick.force_n, from: 50, to: 400, count: 8, scale: log},
  y: {keys: [stops.0.restitution, stops.0.casing.damping_ratio], factors: [1, 0.5], values: [0.5, 0.9]}}')
header+=,kick.force_n,stops.0.restitution,stops.0.casing.damping_ratio
expect_exit 0 "${axes[@]}" --check
expect_contains stdout '16 cells'
expect_exit 0 "${axes[@]}" --explain
expect_contains stdout 'and 2 values of stops.0.restitution, stops.0.casing.damping_ratio (times 0.5) from 0.5 to 0.9'
expect_exit 0 "${axes[@]}" --output whole --report --threads 1
expect_files whole config.yaml map.csv report.html
expect_whole_rows whole/map.csv
expect_contains whole/map.csv '# keys kick.force_n,stops.0.restitution,stops.0.casing.damping_ratio'
[[ $(rows whole/map.csv | wc -l) == 16 ]] || fail 'not 16 rows'

# The last cell is that of a configuration that says its numbers itself.
one_cell 75 0.4
expect_exit 0 "$minimal" "${cell[@]}" --output one --set kick.force_n=400 --set stops.0.restitution=0.9 \
  --set stops.0.casing.damping_ratio=0.45
[[ $(rows whole/map.csv | tail -n 1) == "$(rows one/map.csv),400,0.9,0.45" ]] || fail 'the cell is another one with --set'

expect_exit 0 whole/config.yaml --output again --threads 2
expect_same again/map.csv whole/map.csv
for shard in 1 2 3; do expect_exit 0 "${axes[@]}" --output parts --shard $shard/3; done
expect_exit 0 "${axes[@]}" --output parts --merge
expect_same parts/map.csv whole/map.csv
"$4" whole/map.csv parts/map.csv >stdout || fail 'the maps compare as different'
expect_contains stdout '16 cells: 16 equal'
if command -v gnuplot >/dev/null; then
  rubplot map whole --output picture
  expect_contains picture.svg 'kick.force'
fi

# Three axes are a map for each value of the third, which no one picture shows.
expect_exit 2 "${axes[@]}" --set sweep.whirl_ratio.values='[0.4, 0.5]' --output three --report
expect_contains stderr 'whirl_ratio, kick.force_n, stops.0.restitution have several values'
expect_missing three/map.csv

# Refused before the run, at the place that names the key.
sed 's/^sweep:/&\n  x: {key: kick.forc_n, values: [100]}/' "$minimal" >typo.yaml
line=$(grep -n forc_n typo.yaml | cut -d: -f1)
expect_exit 2 typo.yaml
expect_contains stderr "typo.yaml:$line:12: kick.forc_n: unknown key (did you mean 'force_n'?)"
expect_missing results
# Numbers that are allowed one by one and not together are a failed row.
expect_exit 4 "$minimal" "${cell[@]}" --output failed --set 'sweep.x={key: stops.0.friction.stribeck.3, values: [0.1]}' \
  --set 'sweep.y={key: response.window_revolutions, values: [64, 128]}' \
  --set 'sweep.z={key: response.max_revolutions, values: [128, 600]}'
[[ $(cells failed/map.csv status) == $'ok\nnot_allowed\nok\nok' ]] || fail 'not the cells that are not allowed'
