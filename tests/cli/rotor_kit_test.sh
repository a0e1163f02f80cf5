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
[[ $(head -n 1 free/sensors.csv) == t_s,speed_hz,shaft_angle_rad,sensor_0_m,sensor_1_m ]] || fail 'another header'
[[ $(wc -l <free/sensors.csv) == 1002 ]] || fail 'not 1001 samples'
identified free/identification.csv natural_frequency_hz 1 29 31

expect_exit 0 "$kit" --run-up 22:40:4 --eccentricity-m 1e-5 --set rotor.modes=2 --output run_up
expect_files run_up bode.csv config.yaml identification.csv sensors.csv
identified run_up/identification.csv critical_speed_hz 0 29 31.5
identified run_up/identification.csv critical_speed_hz 1 29 31.5

expect_exit 0 "$kit" --speed-hz 70 --whirl-ratio 0.7 "${small[@]}" --last-revolutions 2 --output rub
expect_contains stdout 'motion    subharmonic 1/2'

rubsweep=$sweep
expect_exit 0 "$kit" "${small[@]}" --set sweep.speed_hz='{values: [70, 100]}' --set sweep.whirl_ratio='{values: [0.7]}' \
  --output map --quiet
[[ $(cells map/map.csv class order | head -n 1) == subharmonic,2 ]] || fail "another label: $(rows map/map.csv)"

# Command line of the experiments.
rubsweep=$trace
# refused TEXT ARGUMENT...
refused() {
  local text=$1
  shift
  expect_exit 1 "$kit" "$@"
  expect_contains stderr "rubtrace: $text"
}
refused '--free-response and --run-up exclude each other' --free-response --run-up 10:20:1
refused '--speed-hz belongs to a trace' --free-response --speed-hz 3
refused '--duration-s belongs to --free-response' --speed-hz 3 --whirl-ratio 0.1 --duration-s 1
refused 'the unbalance of the run-up is needed' --run-up 10:20:1
refused "--run-up: '10:20' is not allowed" --run-up 10:20 --eccentricity-m 1e-5
refused "--run-up: '10:x:1' is not allowed" --run-up 10:x:1 --eccentricity-m 1e-5
refused '--run-up: allowed: speeds > 0' --run-up 10:20:-1 --eccentricity-m 1e-5
refused '--sample-s: allowed: long enough' --free-response --sample-s 1e-9
