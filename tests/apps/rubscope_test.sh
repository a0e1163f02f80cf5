#!/usr/bin/env bash
# rubscope on recordings that are written here: what it says and writes, and what it refuses. The first argument is
# rubscope, the fourth rubtrace.
source "$(dirname "$0")/support.sh"
trace=$4

# A 1/2 motion at 70 rev/s in microvolts of two probes, with a keyway: as an instrument writes it.
awk 'BEGIN {
  pi = atan2(0, -1)
  print "time [s];X [mV];Y [mV];KP [V]"
  for (k = 0; k < 5000; ++k) {
    t = k / 5000; turns = 70 * t
    x = 80 * cos(2 * pi * turns) + 60 * cos(pi * turns); y = 80 * sin(2 * pi * turns) + 20 * sin(pi * turns)
    printf "%.4f;%.3f;%.3f;%d\n", t, 8 * x, 8 * y, turns - int(turns) < 0.08 ? -12 : -2
  }
}' | tr . , >run.csv
printf '%s\n' 'time: time' 'keyphasor: {column: KP}' 'probes:' '  - {column: X, angle_deg: 0, gain_mv_per_um: 8}' \
  '  - {column: Y, angle_deg: 90, gain_mv_per_um: 8}' >run.yaml

expect_exit 0 run.csv
expect_empty stderr
expect_contains stdout 'subharmonic 1/2, complex orbit, forward whirl'
expect_files run_scope bode.csv lines.csv measures.csv orbit.csv turns.csv waterfall.csv
expect_whole_table run_scope/*.csv
[[ $(count_rows run_scope/lines.csv 'order == 1 and 79.9e-6 < amplitude_m < 80.1e-6') == 1 ]] || fail 'another 1X'
[[ $(count_rows run_scope/measures.csv "quantity == 'period_turns' and value == 2") == 1 ]] || fail 'another period'
expect_exit 0 run.csv --orders 0.5 --quiet
expect_empty stdout
[[ $(count_rows run_scope/bode.csv 'order == 0.5') -gt 50 ]] || fail 'no 1/2 in the Bode plot'

# A listing of the file, without a description.
cp run.csv bare.csv
expect_exit 0 bare.csv --columns
expect_empty stderr
expect_contains stdout 'bare.csv: 4 columns of 5000 readings, from line 2 to line 5001'
expect_contains stdout "'time' rises evenly, by 0.0002 s"
[[ ! -e bare_scope ]] || fail 'a listing writes files'
printf 'no numbers\n' >words.txt
expect_exit 2 words.txt --columns
expect_contains stderr 'words.txt:1:1: has no numbers, allowed: '

# Thresholds in per cent.
expect_exit 0 run.csv --least-line 80 --most-modulation 0 --output coarse
expect_contains stdout 'synchronous'
expect_exit 1 run.csv --most-modulation 100
expect_contains stderr '--most-modulation: 100, allowed: from 0 to below 100 (per cent)'

# A stretch of it.
{ cat run.yaml; echo 'to_s: 0.2'; } >short.yaml
expect_exit 0 run.csv --instrument short.yaml --output short
expect_contains stdout 's more would tell up to 8'

# The same motion by accelerometers in g, and by velocity in in/s, of a casing.
for form in 'g 2 9.80665e6' 'in/s 1 25400'; do
  read -r unit times per <<<"$form"
  awk -v unit="$unit" -v times="$times" -v per="$per" 'BEGIN {
    pi = atan2(0, -1); w = 2 * pi * 70
    print "time [s];X [" unit "];Y [" unit "];KP [V]"
    for (k = 0; k < 5000; ++k) {
      a = w * k / 5000; turns = 70 * k / 5000; shift = times * pi / 2
      x = 80 * w ^ times * cos(a + shift) + 60 * (w / 2) ^ times * cos(a / 2 + shift)
      y = 80 * w ^ times * sin(a + shift) + 20 * (w / 2) ^ times * sin(a / 2 + shift)
      printf "%.4f;%.9g;%.9g;%d\n", k / 5000, x / per, y / per, turns - int(turns) < 0.08 ? -12 : -2
    }
  }' >moved.csv
  printf '%s\n' 'time: time' 'keyphasor: {column: KP}' \
    'probes: [{column: X, angle_deg: 0}, {column: Y, angle_deg: 90}]' >moved.yaml
  expect_exit 0 moved.csv --output moved_scope
  expect_contains stdout 'subharmonic 1/2, complex orbit, forward whirl'
  expect_contains stdout 'of the casing, integrated'
  expect_contains stdout 'orders below 0.125X (8.75 Hz) are lost'
  expect_contains stdout 'zone D of ISO 20816-3, whatever the machine'
  [[ $(count_rows moved_scope/lines.csv 'order == 1 and 79.9e-6 < amplitude_m < 80.1e-6') == 1 ]] || fail "1X of $unit"
  [[ $(count_rows moved_scope/lines.csv 'order == 0.5 and 39.9e-6 < amplitude_m < 40.1e-6') == 1 ]] || fail "1/2X of $unit"
  expect_exit 2 moved.csv --compare "$top/configs/rotor_kit.yaml" --cell 70,0.6
  expect_contains stderr 'the recording is one of a casing, allowed: one of the shaft'
done

# A simulated kit over its own readings.
"$trace" "$top/configs/rotor_kit.yaml" --speed-hz 70 --whirl-ratio 0.6 --sample-s 2e-4 --noise-m 2e-6 --output kit --quiet
printf '%s\n' 'time: t_s' 'speed_hz: 70' 'from_s: 1' \
  'probes: [{column: sensor_0_m, angle_deg: 0}, {column: sensor_1_m, angle_deg: 90}]' >kit.yaml
expect_exit 0 kit/sensors.csv --instrument kit.yaml --output over --compare "$top/configs/rotor_kit.yaml" --cell 70,0.6
expect_contains stdout 'compared  the simulated motion leaves'
[[ $(count_rows over/compared.csv 'difference < 5') == 32 ]] || fail "lines differ: $(<over/compared.csv)"

# Nothing is written on bad input, and its place is named.
refused() {
  expect_exit 2 "$1" --instrument "$2" --output none
  expect_empty stdout
  expect_contains stderr "$3"
  expect_missing none
}
sed '9s/;[^;]*;/;x1;/' run.csv >letters.csv
refused letters.csv run.yaml "letters.csv:9:8: 'x1' is no number"
# A jump leaves the longest stretch; a step back is no time.
sed '20,30d' run.csv >jump.csv
expect_exit 0 jump.csv --instrument run.yaml --output jumped
expect_contains stdout "'time' jumps from 0.0034 to 0.0058 at line 20: the longest stretch without a jump"
sed '20{h;d};21G' run.csv >back.csv
refused back.csv run.yaml "back.csv:20: 'time' goes from"
sed 's/column: Y/column: Z/' run.yaml >column.yaml
refused run.csv column.yaml "has no column 'Z', allowed: 'time', 'X', 'Y', 'KP'"
sed 's/gain_mv_per_um: 8}/gain: 8}/' run.yaml >gain.yaml
refused run.csv gain.yaml 'gain.yaml:4:'
printf 'RIFFxxxxWAVE' >broken.wav
refused broken.wav run.yaml 'broken.wav: is damaged'
printf 'MATLAB 5.0 MAT-file, cut' >broken.mat
refused broken.mat run.yaml 'broken.mat: '
expect_usage_error '--compare and --cell go together' run.csv --cell 70,0.6
expect_usage_error "--orders: '0.3'" run.csv --orders 0.3
expect_usage_error 'one recording is needed'
