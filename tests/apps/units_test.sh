#!/usr/bin/env bash
# Speeds in rpm and unbalances in g mm, by ends and on a logarithmic scale, come back so; a likely slip is asked about.
source "$(dirname "$0")/support.sh"
rubtrace=$4 ringstab=$5

shop=("$minimal" --set 'sweep={speed_rpm: {from: 3100, to: 12000, count: 4, scale: log}, unbalance_g_mm: {values: [80, 240.1]}}'
  --set 'title=Pump 7' --set 'note="first\nsecond"' --set kick.force_n=50)
expect_exit 0 "${shop[@]}" --output shop
expect_contains shop/map.csv "$header,speed_rpm,unbalance_g_mm"
[[ $(grep -v '^#' shop/map.csv | sed -n '2p;9p' | sed 's/.*,\([^,]*,[^,]*\)$/\1/' | tr '\n' ' ') == '3100,80 12000,240.1 ' ]] ||
  fail 'the last columns are not what was written'
expect_contains shop/config.yaml 'title: "Pump 7"'
expect_contains shop/config.yaml 'note: "first\nsecond"'
sed -n '/speed_rpm/,/values/p' shop/config.yaml | tr -d '\n ' >axis
[[ $(<axis) == 'speed_rpm:from:3100to:12000count:4scale:logunbalance_g_mm:values:[80,240.1]' ]] || fail "axes: $(<axis)"

# The same study in SI units goes on with the same journal and the same map, whatever columns that has.
expect_exit 0 shop/config.yaml --check
expect_exit 0 "$minimal" --output shop --set kick.force_n=50 --set \
  "sweep={speed_hz: {values: [$(grep -v '^#' shop/map.csv | sed -n 2,5p | cut -d, -f1 | paste -sd,)]}, eccentricity_m: {values: [1.0e-4, 3.00125e-4]}}"
expect_contains stderr 'the map is there, nothing is left to do'
expect_contains stdout 'non_contact'

expect_exit 0 "${shop[@]}" --explain
expect_contains stdout 'sweep: 8 cells, 4 speeds from 3100 to 12000 rpm (51.6667 to 200 Hz), logarithmic, 2 unbalances from 80 to 240.1 g mm'

"$rubtrace" "$minimal" --speed-rpm 3240 --unbalance-g-mm 240 --revolutions 20 --output trace >stdout 2>stderr || true
expect_matches trace/motion.csv ',speed_rpm,unbalance_g_mm$'
expect_matches trace/motion.csv ',3240,240$'
tr -d '\n ' <trace/config.yaml >axis
expect_contains axis 'speed_rpm:values:[3240]unbalance_g_mm:values:[240]'

# Questions are for people, not for scripts.
expect_exit 0 "$minimal" --check --set sweep.whirl_ratio=40
expect_contains stderr 'rubsweep: question: --set sweep.whirl_ratio=40: sweep.whirl_ratio: 40 times the clearance is no quiet motion (per cent?)'
expect_exit 0 "$minimal" --check --quiet --set sweep.whirl_ratio=40
expect_empty stderr
"$rubtrace" "$minimal" --speed-hz 60 --eccentricity-m 0.3 --revolutions 2 --output slip >stdout 2>stderr || true
expect_contains stderr 'rubtrace: question: the unbalance: 0.3 m is 300 clearances (millimetres?)'

# A kick too weak is asked about with its place, and the exit code stays.
sed 's/force_n: 200/force_n: 4/' "$minimal" >weak.yaml
expect_exit 0 weak.yaml --check
expect_matches stdout '^weak\.yaml: ok, 24 cells$'
expect_matches stderr '^rubsweep: question: weak\.yaml:[0-9]+:[0-9]+: kick\.force_n: 4 N reach no wall from any cell \(more than [0-9.]+ N\?\)$'
more=$(sed -E 's/.*more than ([0-9.]+) N.*/\1/' stderr)
expect_exit 0 weak.yaml --check --set "kick.force_n=$(awk "BEGIN {print 1.02 * $more}")"
expect_empty stderr
# Places of other questions, in the file.
printf 'base: %s\nrotor: {damping_ratio: 0.5}\n' "$minimal" >damped.yaml
expect_exit 0 damped.yaml --check
expect_contains stderr 'rubsweep: question: damped.yaml:2:24: rotor.damping_ratio: 0.5 of critical damping is much for a rotor (per cent?)'

# A motion beyond 100 clearances asks what was meant.
expect_exit 0 "$minimal" --set sweep.eccentricity_m=2 --output far
expect_contains stderr 'question: what was the unbalance meant to be?'

# Each program knows the files of the other.
ring=$top/configs/ring/figure10.yaml
expect_exit 2 "$ring" --check
expect_contains stderr 'ring: belongs to a configuration of ringstab, allowed: ringstab with this file'
code=0
"$ringstab" "$minimal" --check >stdout 2>stderr || code=$?
[[ $code == 2 ]] || fail "ringstab: exit code $code"
expect_contains stderr 'belongs to a configuration of rubsweep, allowed: rubsweep with this file'
