#!/usr/bin/env bash
# rubtrace --design-check: what it writes, what it prints and what it refuses.
source "$(dirname "$0")/support.sh"
table=$top/configs/gallery/bearing_table.yaml
files=(config.yaml design_check.csv kicks.csv lock_speeds.csv unbalance_response.csv)

# Command line.
refused() {
  local text=$1
  shift
  expect_usage_error "$text" "$minimal" "$@"
}
for range in 10 10:x 20:10 0:10 -1:10 10:20:3 nan:20; do
  refused "--operating-hz: '$range' is not allowed, allowed: FROM:TO" --design-check --operating-hz="$range"
done
refused "--operating-rpm: '10' is not allowed" --design-check --operating-rpm 10
refused '--operating-hz and --operating-rpm exclude each other' --design-check --operating-hz 50:60 --operating-rpm 3000:3600
refused '--operating-hz and --operating-rpm belong to --design-check' --campbell 10:20 --operating-hz 50:60
refused '--kick-speeds belongs to --design-check' --campbell 10:20 --kick-speeds 3
refused '--threads belongs to --design-check' --speed-hz 60 --whirl-ratio 0.3 --threads 2
refused '--stage belongs to --design-check' --campbell 10:20 --stage none
refused '--require-pass belongs to --design-check' --campbell 10:20 --require-pass
for stage in impeller impeller:100:2:400 impeller:100:2:400:0 blades:1:2:3:4 pump:1:2:3:4 impeller:x:2:400:15 ''; do
  refused "--stage: '$stage' is not allowed, allowed: impeller:KW" --design-check --stage "$stage"
done
refused "--stage: 'none' is not allowed" --design-check --stage none --stage blades:100:400:30
refused '--kick-speeds: allowed: a number from 0 to 1000' --design-check --kick-speeds -1
refused '--threads: allowed: a number from 0' --design-check --threads -1
refused '--free-response, --run-up, --campbell and --design-check exclude each other' --design-check --campbell 10:20
refused '--whirl-ratio belongs to a trace' --design-check --whirl-ratio 0.3
refused '--operating-hz: 4500 Hz is over 100 times the lowest natural frequency' --design-check --operating-hz 50:4500
refused '--design-check: the sweep has one speed' --design-check --set 'sweep.speed_hz={values: [60]}'
expect_exit 1 "$table" --design-check --operating-hz 50:200
expect_contains stderr '--operating-hz: the tables of the supports do not reach 200 Hz (12000 rpm)'
expect_exit 2 "$top/configs/rotor_kit.yaml" --design-check --set rotor.discs.0.eccentricity_ratio=0 --kick-speeds 0
expect_contains stderr 'rotor.discs: no disc stands off the axis'
expect_missing results

# A Jeffcott rotor of 30 Hz at 50 to 150 Hz: the numbers of its closed forms.
expect_exit 0 "$minimal" --design-check --kick-speeds 3 --output jeffcott
expect_files jeffcott "${files[@]}"
for file in "${files[@]:1}"; do expect_whole_table "jeffcott/$file"; done
expect_contains stdout 'operating 50 Hz (3000 rpm) to 150 Hz (9000 rpm)'
expect_contains stdout 'vibration 25.4 um peak to peak allowed at the probes'
expect_contains stdout 'eccentricity 2.822 um'
expect_matches stdout '^  stop 0: [0-9.]+ um of 1500 um at 30.0[0-9]* Hz \([0-9.]+ rpm\), margin [0-9.]+ %: ok$'
for speed in 59.988 89.982 149.97; do expect_contains stdout "  $speed Hz"; done
for multiple in 2 3 5; do
  [[ $(count_rows jeffcott/lock_speeds.csv "abs(speed_hz - $multiple * 29.99399939987997) < 1e-6") == 1 ]] ||
    fail "no lock speed at $multiple times the natural frequency: $(<jeffcott/lock_speeds.csv)"
done
[[ $(count_rows jeffcott/kicks.csv 'True') == 6 ]] || fail 'not three even speeds and three lock speeds'
[[ $(count_rows jeffcott/design_check.csv "check == 'vibration' and verdict == 'ok' and unit == 'm'") == 1 ]] ||
  fail "another check of the vibration: $(<jeffcott/design_check.csv)"

# The same in other words, and nothing left of the kicks.
expect_exit 0 "$minimal" --design-check --kick-speeds 0 --operating-rpm 3000:9000 --quiet --output jeffcott
expect_empty stdout
expect_files jeffcott config.yaml design_check.csv lock_speeds.csv unbalance_response.csv
expect_exit 0 "$minimal" --design-check --kick-speeds 0 --eccentricity-m 2.8222222222222223e-06 --output given
expect_contains stdout 'not tried: not asked for'
expect_same <(grep -v '^#' given/design_check.csv) <(grep -v '^#' jeffcott/design_check.csv)

# The answer comes first, and ends the program with a code of its own where that is asked for.
expect_exit 0 "$minimal" --design-check --kick-speeds 0 --stage none --require-pass --output jeffcott
[[ $(head -n 1 stdout) == 'answer    pass' ]] || fail 'another answer than pass'
expect_exit 4 "$minimal" --design-check --kick-speeds 0 --require-pass --output jeffcott
[[ $(head -n 1 stdout) == 'answer    not told: nothing is known of 1 terms' ]] || fail 'another answer than not told'
[[ $(count_rows jeffcott/design_check.csv "check == 'cross_coupling' and verdict == 'not_told'") == 1 ]] || fail 'a stage is told'
expect_exit 4 "$minimal" --design-check --kick-speeds 0 --stage none --require-pass --operating-hz 33:150 --output jeffcott
expect_matches stdout '^answer    NOT MET: [0-9]+ of '
expect_matches stdout '^  separation, configured at probe 0 at 30.01[0-9]* Hz .*: NOT MET$'
expect_exit 0 "$minimal" --design-check --kick-speeds 0 --stage impeller:0.001:2:400:15 --output jeffcott
[[ $(count_rows jeffcott/design_check.csv "check == 'level_1_threshold' and limit == 2") == 1 ]] || fail 'no Level I'

# Both ends of the clearances of a bearing: the worse one is the answer.
refused '--other-end belongs to --design-check' --campbell 10:20 --other-end rotor.damping_ratio=0.02
expect_exit 4 "$minimal" --design-check --kick-speeds 0 --stage none --require-pass --other-end rotor.damping_ratio=0.001 --output ends
[[ $(head -n 1 stdout) == "answer    NOT MET: pass as configured, NOT MET at the other end of the bearings' clearances" ]] ||
  fail "another answer of both ends: $(head -n 1 stdout)"
expect_contains stdout 'other end rotor.damping_ratio=0.001'
expect_whole_table ends/design_check_other_end.csv
[[ $(count_rows ends/design_check_other_end.csv "check == 'level_2' and verdict == 'not_met'") == 1 ]] || fail 'the other end is not told'
[[ $(count_rows ends/design_check.csv "verdict == 'not_met'") == 0 ]] || fail 'the first end is mixed with the other'
expect_exit 0 "$minimal" --design-check --kick-speeds 0 --stage none --require-pass --other-end rotor.damping_ratio=0.05 --output ends
"${rubsweep%/*}/rubsweep" --verify ends >stdout || fail 'the results are not whole'
expect_contains stdout config_other_end.yaml
sed -i 's/damping_ratio: 0.05/damping_ratio: 0.06/' ends/config_other_end.yaml
"${rubsweep%/*}/rubsweep" --verify ends >stdout 2>stderr && fail 'a changed configuration of the other end is whole'
expect_exit 2 "$minimal" --design-check --other-end rotor.damping=1 --output refused
expect_contains stderr '--other-end rotor.damping=1: '
expect_missing refused
expect_exit 2 "$minimal" --check --design-check --other-end rotor.damping_ratio=-1
expect_contains stderr '--other-end rotor.damping_ratio=-1: rotor.damping_ratio: '
expect_exit 0 "$minimal" --design-check --kick-speeds 0 --stage none --output ends
expect_missing ends/design_check_other_end.csv
expect_missing ends/config_other_end.yaml

# Supports by tables: clearances from where the tables begin.
expect_exit 0 "$table" --design-check --kick-speeds 0 --operating-hz 50:100 --output table
expect_contains stdout 'clearances from 30 Hz (1800 rpm) on'
expect_matches stdout '^  stop 0: friction 0.05 of '
