#!/usr/bin/env bash
# ringstab from the command line: what it writes, its errors, every shipped ring configuration.
source "$(dirname "$0")/support.sh"

config=$top/configs/ring/figure10.yaml
small=(--set 'speed_rpm={from: 0, to: 1500, count: 151}')

expect_help threads check explain print-config progress
expect_usage_error 'a configuration file is needed'
expect_usage_error "unrecognised option '--no-such-option'" "$config" --no-such-option
expect_usage_error '--check, --explain and --print-config exclude each other' "$config" --check --explain
expect_usage_error '--threads: allowed: a number from 0 to 1024' "$config" --threads -1
expect_exit 3 nowhere.yaml

# Every shipped configuration is accepted, and so is what --print-config makes of it.
for shipped in "$top"/configs/ring/*.yaml; do
  [[ $(head -c 2 "$shipped") == '# ' ]] || fail "$shipped does not begin with its purpose"
  expect_matches "$shipped" '^# Run time: '
  expect_exit 0 "$shipped" --check
  expect_matches stdout "^$shipped: ok, [1-9][0-9]* speeds"
  expect_exit 0 "$shipped" --print-config
  cp stdout printed.yaml
  expect_exit 0 printed.yaml --print-config
  expect_same stdout printed.yaml
  expect_exit 0 "$shipped" --explain
  expect_matches stdout '^ring: mode of 2 nodal diameters'
done
rm printed.yaml
expect_files . stderr stdout

# A run.
expect_exit 0 "$config" "${small[@]}" --output out
expect_files out config.yaml critical_speeds.csv eigenvalues.csv onsets.csv static_load.csv
expect_contains out/eigenvalues.csv speed_rpm,mode,real_per_s,imaginary_rad_per_s
expect_contains out/onsets.csv kind,speed_rpm,modes,note
expect_contains out/critical_speeds.csv name,closed_form_rpm,numeric_rpm
expect_matches out/onsets.csv '^divergence_begin,164\.2479[0-9]*,ring forward,'
expect_matches out/critical_speeds.csv '^omega_t,954\.92965[0-9]*,954\.92965[0-9]*$'
expect_matches out/static_load.csv '^200,0,-[0-9.]*,[0-9.]*,no$'
expect_matches stdout '^ +224\.061 to +427\.808 rpm  stable$'
[[ $(grep -c 'load 0 flexural' out/eigenvalues.csv) -ge 151 ]] || fail 'a mode is missing at some speed'
expect_exit 0 out/config.yaml --output again --quiet
expect_empty stdout
expect_same out/eigenvalues.csv again/eigenvalues.csv
expect_same out/onsets.csv again/onsets.csv

# A chart: the same with any number of threads; the next run without one takes its files away.
chart=(--set 'chart={parameter: inclination_deg, load: 0, over: {from: 0, to: 90, count: 7}}')
expect_exit 0 "$config" "${small[@]}" "${chart[@]}" --output out --threads 1
expect_files out config.yaml critical_speeds.csv eigenvalues.csv onsets.csv static_load.csv chart.csv chart_onsets.csv
[[ $(grep -c ',ok$' out/chart.csv) == 1057 ]] || fail 'the chart has not 7 x 151 points'
expect_exit 0 "$config" "${small[@]}" "${chart[@]}" --output again --threads 2
expect_same out/chart.csv again/chart.csv
expect_same out/chart_onsets.csv again/chart_onsets.csv
expect_exit 0 "$config" "${small[@]}" --output out
expect_missing out/chart.csv

# A file may be written over another one; what is kept stands alone.
mkdir -p elsewhere
cp "$config" elsewhere/machine.yaml
printf 'base: elsewhere/machine.yaml\nfriction_coefficient: 0.25\nspeed_rpm: {from: 0, to: 1500, count: 151}\n' >based.yaml
expect_exit 0 based.yaml --print-config
cp stdout merged
expect_exit 0 "$config" "${small[@]}" --set friction_coefficient=0.25 --print-config
expect_same stdout merged
expect_exit 0 based.yaml --output based --quiet
expect_same based/config.yaml merged
sed -i 's/^friction_coefficient:.*/friction_coefficient: -1/' elsewhere/machine.yaml
expect_exit 0 based.yaml --check
sed -i '/^friction_coefficient/d' based.yaml
expect_exit 2 based.yaml --check
expect_matches stderr '^elsewhere/machine\.yaml:[0-9]+:[0-9]+: friction_coefficient: -1 is out of range'
rm -r elsewhere based based.yaml merged

# Errors: place, path, what is wrong, what is allowed.
expect_exit 2 "$config" --set ring.nodal_diameter=2
expect_matches stderr "^--set ring\.nodal_diameter=2: ring\.nodal_diameter: unknown key \(did you mean 'nodal_diameters'\?\)"
expect_exit 2 "$config" --set loads.0.inclination_deg=91
expect_contains stderr 'loads.0.inclination_deg: 91 is out of range, allowed: a number >= -90 and <= 90'
sed 's/mass_kg: 100/mass_kg: 0/; s/friction_coefficient/friction_coeficient/' "$config" >bad.yaml
expect_exit 2 bad.yaml
expect_matches stderr '^bad\.yaml:[0-9]+:[0-9]+: loads\.0\.mass_kg: 0 is out of range, allowed: a number > 0$'
expect_matches stderr "^bad\.yaml:[0-9]+:1: friction_coeficient: unknown key \(did you mean 'friction_coefficient'\?\)"
expect_exit 2 "$top/configs/minimal.yaml"
expect_contains stderr 'rotor: belongs to a configuration of rubsweep'
