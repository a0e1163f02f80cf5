#!/usr/bin/env bash
# rubfit on experiments that rubtrace made: what it finds and writes, and what it refuses. The first argument is rubfit,
# the fourth rubtrace.
source "$(dirname "$0")/support.sh"
trace=$4

# found PARAMETER FROM TO: the value lies between, and its interval holds a number there.
found() {
  [[ $(count_rows out/parameters.csv "parameter == '$1' and $2 < value < $3") == 1 ]] ||
    fail "$1 is not between $2 and $3: $(<out/parameters.csv)"
}

start=(--set rotor.natural_frequency_hz=31.5 --set rotor.damping_ratio=0.03)
"$trace" "$minimal" --free-response --duration-s 1 --noise-m 5e-6 --output free --quiet
expect_exit 0 "$minimal" "${start[@]}" --ring-down free/sensors.csv --from-s 0.006 --fit rotor.natural_frequency_hz \
  --fit rotor.damping_ratio --fit hit_s=-0.002:0.002 --output out
expect_empty stderr
expect_files out config.yaml correlation.csv fitted.csv parameters.csv
expect_whole_table out/*.csv
found rotor.natural_frequency_hz 29.98 30.02
found rotor.damping_ratio 0.0197 0.0203
expect_contains stdout 'fit       1990 numbers of data, 3 parameters; settled'
# The configuration that was found is one.
expect_exit 0 out/config.yaml --ring-down free/sensors.csv --from-s 0.006 --fit rotor.damping_ratio --output again

"$trace" "$minimal" --run-up 22:40:4 --eccentricity-m 1e-5 --output run_up --quiet
expect_exit 0 "$minimal" "${start[@]}" --ramp run_up/bode.csv --rate-hz-per-s 4 --fit rotor.natural_frequency_hz \
  --fit rotor.damping_ratio --fit eccentricity_m=1e-6:1e-4 --fit mark_deg --compare-without mark_deg --output out
found rotor.natural_frequency_hz 29.99 30.01
found rotor.damping_ratio 0.0199 0.0201
found eccentricity_m 0.99e-5 1.01e-5
expect_contains stdout 'compared  without mark_deg'

# A number that the data do not tell, since nothing turns in a ring-down.
expect_exit 0 "$minimal" --ring-down free/sensors.csv --from-s 0.006 --fit rotor.damping_ratio --fit rotor.mass_kg --output out
expect_contains stdout 'the data do not tell rotor.mass_kg'

expect_usage_error '--fit rotor.damping: is no number of the configuration' "$minimal" --ring-down free/sensors.csv \
  --fit rotor.damping
expect_usage_error '--fit: a number to be found is needed' "$minimal" --ring-down free/sensors.csv
expect_usage_error 'data are needed' "$minimal" --fit rotor.damping_ratio
expect_usage_error '--fit eccentricity_m: begins at 0' "$minimal" --ramp run_up/bode.csv --rate-hz-per-s 4 --fit eccentricity_m
expect_usage_error '--fit hit_s=2:1: allowed' "$minimal" --ring-down free/sensors.csv --fit hit_s=2:1
sed '20s/,[^,]*$/,x/' free/sensors.csv >broken.csv
expect_exit 3 "$minimal" --ring-down broken.csv --fit rotor.damping_ratio --output none
expect_contains stderr 'broken.csv:20'
expect_missing none
