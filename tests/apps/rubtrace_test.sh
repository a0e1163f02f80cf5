#!/usr/bin/env bash
# rubtrace: what it writes, what it prints and how it ends. The fourth argument is rubsweep, the program of the map.
source "$(dirname "$0")/support.sh"
sweep=$4
rub=(--speed-hz 90 --whirl-ratio 0.6)
files=(config.yaml events.csv motion.csv section.csv spectrum.csv trajectory.csv)

# expect_header FILE HEADER ROWS
expect_header() {
  [[ $(header_of "$1") == "$2" ]] || fail "$1 has another header"
  [[ $(($(grep -vc '^#' "$1") - 1)) == "$3" ]] || fail "$1 has not $3 rows"
}

# Command line.
expect_help speed-hz speed-rpm whirl-ratio eccentricity-m unbalance-g-mm revolutions last-revolutions free-response run-up with-stops campbell design-check operating-hz operating-rpm kick-speeds stage require-pass threads figure duration-s sample-s noise-m probe length-unit peak-to-peak check explain print-config
expect_usage_error 'a configuration file is needed' "${rub[@]}"
expect_usage_error 'the shaft speed is needed' "$minimal" --whirl-ratio 0.6
expect_usage_error 'the unbalance is needed, one way' "$minimal" --speed-hz 90
expect_usage_error '--whirl-ratio and --eccentricity-m exclude each other' "$minimal" "${rub[@]}" --eccentricity-m 1e-4
expect_usage_error '--eccentricity-m and --unbalance-g-mm exclude each other' "$minimal" --speed-hz 90 --eccentricity-m 1e-4 --unbalance-g-mm 80
expect_usage_error '--speed-hz and --speed-rpm exclude each other' "$minimal" "${rub[@]}" --speed-rpm 5400
expect_usage_error 'the unbalance of the run-up is needed' "$minimal" --run-up 20:40:10
expect_usage_error '--speed-rpm: allowed: a number > 0' "$minimal" --speed-rpm 0 --whirl-ratio 0.6
expect_usage_error '--speed-hz: allowed: a number > 0' "$minimal" --speed-hz 0 --whirl-ratio 0.6
expect_usage_error '--speed-hz: allowed: a number > 0' "$minimal" --speed-hz inf --whirl-ratio 0.6
expect_usage_error '--speed-hz: 4500 Hz is over 100 times the lowest natural frequency' "$minimal" --speed-hz 4500 --whirl-ratio 0.6
expect_usage_error '--run-up: 4500 Hz is over 100 times the lowest natural frequency' "$minimal" --run-up 20:4500:1000 --eccentricity-m 1e-5
expect_usage_error '--sample-s: 0.02 s are too long to see 30 Hz' "$minimal" --free-response --sample-s 0.02
expect_usage_error '--whirl-ratio: allowed: a number >= 0' "$minimal" --speed-hz 90 --whirl-ratio -0.1
expect_usage_error '--whirl-ratio: allowed: a number >= 0' "$minimal" --speed-hz 90 --whirl-ratio nan
expect_usage_error '--revolutions: allowed: a number >= 1' "$minimal" "${rub[@]}" --revolutions 0
expect_usage_error '--last-revolutions: allowed: a number >= 1' "$minimal" "${rub[@]}" --last-revolutions -3
expect_usage_error '--output: allowed: the name of a directory' "$minimal" "${rub[@]}" --output ''
expect_usage_error "unrecognised option '--revolution' (did you mean '--revolutions'?)" "$minimal" "${rub[@]}" --revolution 3
expect_usage_error 'too many positional options' "$minimal" "$minimal" "${rub[@]}"

expect_usage_error "--probe: 'casing:velocity:0' is not understood, allowed: PLACE:QUANTITY:ANGLE_DEG[:NOISE]" "$minimal" "${rub[@]}" --probe casing:velocity:0
expect_usage_error '--probe belongs to a trace' "$minimal" --free-response --probe shaft:velocity:0
expect_usage_error "--noise-m is that of a machine's sensors; the noise of a --probe stands behind its angle" "$minimal" "${rub[@]}" --probe shaft:velocity:0 --noise-m 1e-6
expect_usage_error "--length-unit: 'inch' is not allowed, allowed: mm, um, mil" "$minimal" "${rub[@]}" --length-unit inch
expect_usage_error '--check, --explain and --print-config exclude each other' "$minimal" "${rub[@]}" --check --explain
expect_usage_error 'the shaft speed is needed' "$minimal" --whirl-ratio 0.6 --check

# Questions about the cell, about an experiment, and about the whole sweep where neither is named; nothing is run.
expect_exit 0 "$minimal" "${rub[@]}" --check
[[ $(<stdout) == "$minimal: ok, 1 cells" ]] || fail 'another answer to --check'
expect_exit 0 "$minimal" --check
[[ $(<stdout) == "$minimal: ok, 24 cells" ]] || fail 'another answer to --check of the sweep'
expect_exit 0 "$minimal" "${rub[@]}" --check --set kick.force_n=4
expect_matches stderr '^rubtrace: question: --set kick\.force_n=4: kick\.force_n: 4 N reach no wall from any cell'
expect_exit 0 "$minimal" "${rub[@]}" --check --quiet --set kick.force_n=4
expect_empty stdout
expect_empty stderr
expect_exit 2 "$minimal" --check --set rotor.mass_kg=-1
expect_matches stderr '^--set rotor\.mass_kg=-1: rotor\.mass_kg: -1 is out of range'
expect_exit 1 "$minimal" --speed-hz 4500 --whirl-ratio 0.6 --explain
expect_exit 0 "$minimal" --speed-rpm 5400 --whirl-ratio 0.6 --explain
expect_contains stdout 'rotor: Jeffcott'
expect_matches stdout '^sweep: 1 cells, speed 5400 rpm \(90 Hz\), whirl ratio 0\.6$'
expect_exit 0 "$minimal" "${rub[@]}" --explain
mv stdout of_cell
"$sweep" "$minimal" --explain --set sweep.speed_hz=90 --set sweep.whirl_ratio=0.6 | grep -v ' of memory, ' >of_sweep
expect_same of_cell of_sweep
expect_exit 0 "$minimal" "${rub[@]}" --print-config
expect_contains <(tr -d ' \n' <stdout) 'speed_hz:values:[90]'
expect_exit 0 "$minimal" --run-up 20:60:10 --eccentricity-m 1e-4 --with-stops --explain
expect_contains stdout 'experiment: run-up with the stops by 10 Hz a second, eccentricity 0.0001 m, 20 to 60 Hz (1200 to 3600 rpm)'
expect_contains stdout 'rotor: Jeffcott'
expect_exit 0 "$minimal" --campbell 0:100 --check
[[ $(<stdout) == "$minimal: ok, Campbell diagram without the stops, 101 speeds, 0 to 100 Hz (0 to 6000 rpm)" ]] ||
  fail 'another answer to --check of a Campbell diagram'
expect_exit 0 "$minimal" --free-response --explain
expect_contains stdout 'experiment: response to the kick at standstill without the stops, 2 s'
expect_exit 0 "$minimal" --design-check --check
expect_contains stdout 'ok, design check over the operating range, 50 to 150 Hz (3000 to 9000 rpm)'
expect_missing results
rm -f of_cell of_sweep

# A value of an axis over keys is that of the cell.
expect_exit 0 "$minimal" "${rub[@]}" --set 'sweep.x={key: rotor.mass_kg, values: [2]}' --output of_axis
expect_exit 0 "$minimal" "${rub[@]}" --set rotor.mass_kg=2 --output of_key
for file in config.yaml motion.csv; do expect_same <(grep -v '^output\|directory' of_axis/$file) <(grep -v '^output\|directory' of_key/$file); done
rm -r of_axis of_key
expect_exit 2 "$minimal" "${rub[@]}" --set 'sweep.x={key: rotor.mass_kg, values: [1, 2]}'
expect_contains stderr 'rotor.mass_kg has 2 values, and a cell has one, allowed: --set rotor.mass_kg=VALUE'

# Configuration and files that cannot be had.
expect_exit 2 "$minimal" "${rub[@]}" --set rotor.mass_kg=-1
expect_matches stderr '^--set rotor\.mass_kg=-1: rotor\.mass_kg: -1 is out of range'
expect_exit 3 no_such_file.yaml "${rub[@]}"
expect_matches stderr '^rubtrace: .*no_such_file\.yaml'
echo precious >file
expect_exit 3 "$minimal" "${rub[@]}" --output file/below
expect_matches stderr '^rubtrace: .*file/below'
for span in '' '--last-revolutions 1'; do
  # shellcheck disable=SC2086  # several arguments
  expect_exit 2 "$minimal" "${rub[@]}" --revolutions 1000000000000 $span
  expect_matches stderr '^--revolutions: 1000000000000 revolutions take about [0-9.e+]+ GB of memory, this machine has [0-9.]+ GB, allowed: fewer'
done
expect_missing results
# Memory that the machine has, but this process may not take.
(
  ulimit -v 150000
  expect_exit 70 "$minimal" "${rub[@]}" --revolutions 20000
)
[[ $(<stderr) == 'rubtrace: out of memory' ]] || fail 'another message'
rm -rf results

# Probes of a casing; the columns say what they measure.
expect_exit 2 "$minimal" "${rub[@]}" --probe stop1:velocity:0
expect_contains stderr '--probe stop1:velocity:0: the machine has no stop 1, allowed: stop0 to stop0'
expect_missing results
expect_exit 0 "$minimal" "${rub[@]}" --sample-s 1e-3 --probe stop0:acceleration:90 --probe stop0:velocity:90 --probe shaft-stop0:displacement:90 --output probes
[[ $(header_of probes/sensors.csv) == t_s,speed_hz,shaft_angle_rad,sensor_0_m_per_s2,sensor_1_m_per_s,sensor_2_m ]] ||
  fail 'sensors.csv has another header'
expect_contains stdout 'probes    no two of them see one place from two directions'
rm -r probes

# A rub that persists, over all the revolutions of the configuration.
expect_exit 0 "$minimal" "${rub[@]}"
expect_empty stderr
mv results/minimal_trace trace
expect_files trace "${files[@]}"
expect_header trace/trajectory.csv t_s,x_m,y_m,vx_m_per_s,vy_m_per_s,casing_0_x_m,casing_0_y_m,gap_0_m,normal_force_0_n\
,friction_force_0_n,casing_0_vx_m_per_s,casing_0_vy_m_per_s,kinetic_energy_j,elastic_energy_j,contact_energy_j\
,forcing_power_w,damping_power_w,contact_damping_power_w,friction_power_w $((600 * 128))
expect_header trace/section.csv revolution,t_s,x_m,y_m,vx_m_per_s,vy_m_per_s,casing_0_x_m,casing_0_y_m\
,casing_0_vx_m_per_s,casing_0_vy_m_per_s 601
expect_header trace/spectrum.csv order,frequency_hz,amplitude_m $((64 * 128))
[[ $(header_of trace/events.csv) == t_s,stop,from,to ]] || fail 'events.csv has another header'
expect_whole_rows trace/motion.csv
expect_contains stdout 'cell      90 Hz (5400 rpm), whirl ratio 0.6, '
expect_contains stdout 'motion    subharmonic 1/2, '
expect_contains stdout 'contact   0.5 hits per revolution'
expect_matches stdout '^lines     [-+]0\.5X '
expect_contains stdout 'files     results/minimal_trace: config.yaml events.csv motion.csv'

# The same text in other units; the files are the same.
expect_exit 0 "$minimal" "${rub[@]}" --revolutions 64 --output in_metres
sed -nE 's/^lines +\+0\.5X ([0-9.e-]+) m,.*/\1/p' stdout >metres
expect_exit 0 "$minimal" "${rub[@]}" --revolutions 64 --output in_mils --length-unit mil --peak-to-peak
sed -nE 's/^lines +\+0\.5X ([0-9.e-]+) mil peak to peak,.*/\1/p' stdout >mils
awk "BEGIN {ratio = $(<mils) * 25.4e-6 / (2 * $(<metres)); exit !(ratio > 0.999 && ratio < 1.001)}" ||
  fail "$(<mils) mil peak to peak are not $(<metres) m"
for file in trajectory.csv motion.csv spectrum.csv; do expect_same in_metres/$file in_mils/$file; done

# The row is that of the map, and the configuration beside it makes that map.
rubtrace=$rubsweep rubsweep=$sweep
expect_exit 0 trace/config.yaml --output map
expect_same <(grep -v '^# \(files\|sha256\|sum\) ' trace/motion.csv) <(grep -v '^# \(sha256\|sum\) ' map/map.csv)

# The same cell in other units: 5400 revolutions per minute, 240 g mm on 0.8 kg, also of a run-up.
rubsweep=$rubtrace
expect_exit 0 "$minimal" --speed-hz 90 --eccentricity-m 3e-4 --output si --quiet
expect_exit 0 "$minimal" --speed-rpm 5400 --unbalance-g-mm 240 --output others --quiet
for file in "${files[@]}"; do
  # These keep the units of the command line.
  [[ $file == config.yaml || $file == motion.csv ]] ||
    expect_same <(grep -vE '^# (sha256|sum) ' "others/$file") <(grep -vE '^# (sha256|sum) ' "si/$file")
done
expect_same <(grep -vE '^(# sha256|# sum|[a-z_,0-9]*speed_hz)' others/motion.csv | sed -E 's/,5400,240$//') \
  <(grep -vE '^(# sha256|# sum|[a-z_,0-9]*speed_hz)' si/motion.csv)
expect_contains others/config.yaml 'speed_rpm:'
expect_exit 0 "$minimal" --run-up 20:40:10 --eccentricity-m 3e-4 --output run_up_si --quiet
expect_exit 0 "$minimal" --run-up 20:40:10 --unbalance-g-mm 240 --output run_up_others --quiet
expect_same run_up_others/bode.csv run_up_si/bode.csv
rubsweep=$sweep
expect_exit 0 "$minimal" --output map --fresh
rows trace/motion.csv >row
grep -qxF -f row map/map.csv || fail 'the map has another row for this cell'
rubsweep=$rubtrace

# The two lines of the rub are in the spectrum, with the amplitude of the row.
IFS=, read -r order amplitude_m eccentricity_m < <(cells trace/motion.csv dominant_order dominant_amplitude_m eccentricity_m)
[[ $(count_rows trace/spectrum.csv "order == $order and abs(amplitude_m - $amplitude_m) < 1e-9 * $amplitude_m") == 1 ]] ||
  fail 'the dominant line is not in spectrum.csv'

# Fewer revolutions, fewer of them in the trajectory, nothing said; the row stays that of the map.
expect_exit 0 "$minimal" "${rub[@]}" --revolutions 20 --last-revolutions 5 --quiet --output short
expect_empty stdout
expect_files short "${files[@]}"
[[ $(grep -vc '^#' short/trajectory.csv) == $((5 * 128 + 1)) ]] || fail 'not five revolutions in trajectory.csv'
[[ $(grep -vc '^#' short/section.csv) == 22 ]] || fail 'not twenty revolutions in section.csv'
[[ $(grep -v '^#' short/trajectory.csv | tail -n +2) == "$(grep -v '^#' trace/trajectory.csv | tail -n +$((15 * 128 + 2)) | head -n $((5 * 128)))" ]] ||
  fail 'not the last five revolutions in trajectory.csv'
expect_same short/motion.csv trace/motion.csv

# The unbalance said the other way.
expect_exit 0 "$minimal" --speed-hz 90 --eccentricity-m "$eccentricity_m" --revolutions 20 --output other
[[ $(cells other/motion.csv class order) == subharmonic,2 ]] || fail 'another motion by eccentricity'
expect_contains other/config.yaml "values: [$eccentricity_m]"

# Where the quiet whirl itself touches the trace starts at rest, and what the kick is does not matter.
expect_exit 0 "$minimal" --speed-hz 90 --whirl-ratio 1.2 --revolutions 20 --output above
expect_files above "${files[@]}"
[[ $(cells above/motion.csv status start) == ok,contact ]] || fail 'the row does not say that it started without a kick'
[[ $(grep -v '^#' above/section.csv | sed -n 2p) =~ ^0(,0){9}$ ]] || fail "the trace does not start at rest: $(grep -v '^#' above/section.csv | sed -n 2p)"
expect_exit 0 "$minimal" --speed-hz 90 --whirl-ratio 1.2 --revolutions 20 --set kick.force_n=9999 --output harder
expect_same <(grep -v '^#' above/trajectory.csv) <(grep -v '^#' harder/trajectory.csv)

# At an undamped resonance there is no quiet whirl, and a run from rest needs none, at one speed or on a ramp.
resonance=("$minimal" --eccentricity-m 2e-5 --set rotor.damping_ratio=0)
expect_exit 4 "${resonance[@]}" --speed-hz 30 --output none --quiet
expect_exit 0 "${resonance[@]}" --speed-hz 30 --set start=rest --revolutions 40 --output rest
[[ $(cells rest/motion.csv status start) == ok,state ]] || fail 'a run from rest at a resonance does not run'
expect_exit 0 "${resonance[@]}" --run-up 30:34:4 --with-stops --set start=rest --output ramp --quiet

# Nothing to run: the row says so, and nothing of an older trace stays.
expect_exit 4 "$minimal" --speed-hz 90 --whirl-ratio 1.2 --set gravity_m_per_s2=99 --set stops.0.angle_deg=-90 --output short
expect_matches stderr '^rubtrace: static forces press the rotor on the wall'
expect_files short config.yaml motion.csv
[[ $(cells short/motion.csv class status) == initial_contact,ok ]] || fail 'the row is not that of initial contact'
expect_exit 4 "$minimal" --speed-hz 30 --whirl-ratio 0.5 --set rotor.damping_ratio=0 --output short
expect_matches stderr '^rubtrace: no eccentricity gives this whirl ratio'
[[ $(cells short/motion.csv class status) == failed,unreachable ]] || fail 'the row is not that of a failure'

# A run that fails is written up to its failure.
expect_exit 4 "$minimal" "${rub[@]}" --set solver.method=adaptive --set solver.max_steps_per_revolution=1000 --set solver.relative_tolerance=1e-13 \
  --output failed
expect_matches stderr '^rubtrace: the run failed in revolution [0-9]+: step_limit; the files end there$'
failed_in=$(sed -E 's/.*revolution ([0-9]+):.*/\1/' stderr)
expect_files failed "${files[@]}"
[[ $(grep -vc '^#' failed/section.csv) == $((failed_in + 1)) ]] || fail 'section.csv does not end before the failure'
samples=$(($(grep -vc '^#' failed/trajectory.csv) - 1))
((samples > (failed_in - 1) * 128 && samples < failed_in * 128)) || fail 'trajectory.csv does not end at the failure'
[[ $(cells failed/motion.csv class status) == failed,step_limit ]] || fail 'the row does not name the failure'
