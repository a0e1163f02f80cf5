#!/usr/bin/env bash
# The rotor kit in the real programs: a map, a trace, the experiments. The fourth argument is rubsweep.
source "$(dirname "$0")/support.sh"
trace=$rubsweep
sweep=$4
kit=$top/configs/rotor_kit.yaml
# Few modes and revolutions: enough for a label.
small=(--set rotor.modes=2 --set response.max_revolutions=200 --set rotor.damping_ratio=0.06)

# identified FILE QUANTITY SENSOR FROM TO: the value lies between.
identified() {
  [[ $(count_rows "$1" "quantity == '$2' and sensor == $3 and $4 < value < $5") == 1 ]] ||
    fail "$1: $2 of sensor $3 is not between $4 and $5: $(<"$1")"
}

expect_exit 0 "$kit" --free-response --duration-s 1 --noise-m 1e-6 --set rotor.modes=3 --output free
expect_files free config.yaml identification.csv sensors.csv
[[ $(header_of free/sensors.csv) == t_s,speed_hz,shaft_angle_rad,sensor_0_m,sensor_1_m ]] || fail 'another header'
[[ $(grep -vc '^#' free/sensors.csv) == 1002 ]] || fail 'not 1001 samples'
identified free/identification.csv natural_frequency_hz 1 29 31

expect_exit 0 "$kit" --run-up 22:40:4 --eccentricity-m 1e-5 --set rotor.modes=2 --output run_up
expect_files run_up bode.csv config.yaml identification.csv sensors.csv
identified run_up/identification.csv speed_of_largest_1x_hz 0 29 31.5
identified run_up/identification.csv speed_of_largest_1x_hz 1 29 31.5
# Freed of the ramp it is the critical speed of the Campbell diagram, 29.86 Hz.
identified run_up/identification.csv resonance_frequency_hz 0 29.83 29.89
identified run_up/identification.csv resonance_frequency_hz 1 29.83 29.89

# Whirl modes over the speed: the lowest critical speed is that of the run-up, and the gyroscopic moment parts the modes.
expect_exit 0 "$kit" --campbell 0:200:21 --output campbell
expect_files campbell campbell.csv config.yaml critical_speeds.csv lock_speeds.csv mode_shapes.csv
[[ $(header_of campbell/campbell.csv) == speed_hz,mode,whirl,forward_share,frequency_hz,damping_ratio ]] || fail 'another header'
[[ $(count_rows campbell/campbell.csv 'speed_hz == 200') == 7 ]] || fail 'not seven modes below 400 Hz'
[[ $(count_rows campbell/critical_speeds.csv "whirl == 'forward' and 29 < speed_hz < 31") == 1 ]] ||
  fail "another first critical speed: $(<campbell/critical_speeds.csv)"
[[ $(count_rows campbell/critical_speeds.csv "whirl == 'forward' and 110 < speed_hz < 120") == 1 &&
  $(count_rows campbell/critical_speeds.csv "whirl == 'backward' and 95 < speed_hz < 105") == 1 ]] ||
  fail "the second mode does not part: $(<campbell/critical_speeds.csv)"
expect_contains stdout 'critical  29.8568 Hz (1791.41 rpm), mode 2, forward'
# A directory never mixes two experiments.
expect_exit 0 "$kit" --free-response --duration-s 0.1 --set rotor.modes=2 --output campbell --quiet
expect_files campbell config.yaml identification.csv sensors.csv
expect_exit 0 "$minimal" --campbell 0:100 --output jeffcott
[[ $(count_rows jeffcott/critical_speeds.csv 'abs(speed_hz - 29.99399939987997) < 1e-9') == 2 ]] ||
  fail "another critical speed of a Jeffcott rotor: $(<jeffcott/critical_speeds.csv)"

[[ $(count_rows jeffcott/lock_speeds.csv 'abs(speed_hz - 2 * 29.99399939987997) < 1e-9 and p == 3') == 1 &&
  $(count_rows jeffcott/lock_speeds.csv 'abs(speed_hz - 3 * 29.99399939987997) < 1e-9 and p == 2') == 1 ]] ||
  fail "another lock speed of a Jeffcott rotor: $(<jeffcott/lock_speeds.csv)"

expect_exit 0 "$kit" --speed-hz 70 --whirl-ratio 0.7 "${small[@]}" --last-revolutions 2 --output rub
expect_contains stdout 'motion    subharmonic 1/2'

# The same run as the probes see it every 1 ms: 200 turns of 1 / 70 s.
expect_exit 0 "$kit" --speed-hz 70 --whirl-ratio 0.7 "${small[@]}" --last-revolutions 2 --noise-m 2e-6 --output probed
expect_contains stdout 'probes    repeats after 2 turns by 914 readings of sensors 0 (0 deg) and 1 (90 deg) every 0.001 s'
expect_files probed config.yaml events.csv motion.csv probe_spectrum.csv section.csv sensors.csv spectrum.csv trajectory.csv
[[ $(grep -vc '^#' probed/sensors.csv) == 2859 ]] || fail 'not 2858 readings'
expect_same <(grep -v '^# \(files\|sha256\) ' probed/motion.csv) <(grep -v '^# \(files\|sha256\) ' rub/motion.csv)
expect_exit 0 "$kit" --speed-hz 70 --whirl-ratio 0.7 "${small[@]}" --sample-s 1e-3 --set rotor.sensors.1.angle_deg=0 --output one_direction
expect_contains stdout 'probes    no two of them see one place from two directions'

rubsweep=$sweep
expect_exit 0 "$kit" "${small[@]}" --set sweep.speed_hz='{values: [70, 100]}' --set sweep.whirl_ratio='{values: [0.7]}' \
  --output map --quiet
[[ $(cells map/map.csv class order | head -n 1) == subharmonic,2 ]] || fail "another label: $(rows map/map.csv)"

# Run-up through rub: it begins where the whirl grows to the clearance, near where it does at steady speeds.
rubsweep=$trace
expect_exit 0 "$minimal" --run-up 24:50:4 --eccentricity-m 2e-4 --with-stops --output through
expect_files through config.yaml envelope.csv orbits.csv quasi_static.csv rub.csv spectrogram.csv
[[ $(count_rows through/rub.csv "source == 'ramp' and 27 < from_hz < 29 and 42 < to_hz < 47") == 1 ]] || fail "other rub: $(<through/rub.csv)"
[[ $(count_rows through/rub.csv "source == 'quasi_static' and 27 < from_hz < 29 and 42 < to_hz < 45") == 1 ]] ||
  fail "other steady rub: $(<through/rub.csv)"
expect_matches stdout '^steadily  27'
[[ $(count_rows through/envelope.csv 'speed_hz < 26 and peak_contact_force_n > 0') == 0 ]] || fail 'it touches too soon'
[[ $(count_rows through/spectrogram.csv 'order == -1 and amplitude_m > 5e-4') -ge 1 ]] || fail 'no line backward'
expect_exit 0 "$kit" --run-up 24:40:8 --eccentricity-m 2e-4 --with-stops --set rotor.modes=1 --output kit_through --quiet
[[ $(count_rows kit_through/rub.csv "source == 'ramp'") -ge 1 ]] || fail 'the kit does not rub'

# Command line of the experiments.
# refused TEXT ARGUMENT...
refused() {
  local text=$1
  shift
  expect_exit 1 "$kit" "$@"
  expect_contains stderr "rubtrace: $text"
}
refused '--free-response, --run-up, --campbell and --design-check exclude each other' --free-response --run-up 10:20:1
refused '--free-response, --run-up, --campbell and --design-check exclude each other' --campbell 10:20 --run-up 10:20:1
for range in 10 10:x 20:10 -1:10 10:20:1 10:20:2.5 10:20:30:40; do
  refused "--campbell: '$range' is not allowed, allowed: FROM:TO" --campbell="$range"
done
refused '--eccentricity-m belongs to a trace or a run-up' --campbell 10:20 --eccentricity-m 1e-5
refused '--duration-s belongs to --free-response' --campbell 10:20 --duration-s 3
refused '--figure belongs to a trace, to --campbell, to --run-up or to --design-check' --free-response --figure x.png
refused '--figure: allowed: a name that ends with .png, .svg or .pdf' --campbell 10:20 --figure x.gif
refused '--speed-hz belongs to a trace' --free-response --speed-hz 3
refused '--duration-s belongs to --free-response' --speed-hz 3 --whirl-ratio 0.1 --duration-s 1
refused 'the unbalance of the run-up is needed' --run-up 10:20:1
refused "--run-up: '10:20' is not allowed" --run-up 10:20 --eccentricity-m 1e-5
refused "--run-up: '10:x:1' is not allowed" --run-up 10:x:1 --eccentricity-m 1e-5
refused '--run-up: allowed: speeds > 0' --run-up 10:20:-1 --eccentricity-m 1e-5
refused '--with-stops belongs to --run-up' --campbell 10:20 --with-stops
refused '--sample-s: allowed: long enough' --free-response --sample-s 1e-9
refused '--with-stops belongs to --run-up' --campbell 10:20 --with-stops
refused '--sample-s: allowed: long enough' --speed-hz 70 --whirl-ratio 0.7 --sample-s 1e-9
