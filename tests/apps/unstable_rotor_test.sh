#!/usr/bin/env bash
# A rotor that is unstable without its stops is named before the sweep, by --check and --explain, and in its rows.
source "$(dirname "$0")/support.sh"

# 30 Hz (1 + 0.02 / 0.05) = 42 Hz is where the damping that turns with the shaft takes over.
turning=("$minimal" --set rotor.rotating_damping_ratio=0.05 --set 'sweep={speed_hz: {values: [35, 90]}, whirl_ratio: {values: [0.4]}}')
warning='warning: unstable rotor: at 1 of 2 speeds looked at, from 90 to 90 Hz (5400 to 5400 rpm), a free vibration of the rotor without its stops grows'
expect_exit 0 "${turning[@]}" --check
expect_contains stderr "rubsweep: $warning"
expect_exit 0 "${turning[@]}" --explain
expect_contains stdout "${warning#warning: }"
expect_exit 0 "${turning[@]}" --output map
expect_contains stderr "rubsweep: $warning"
[[ $(cells map/map.csv speed_hz status | tr '\n' ' ') == '35,ok 90,unstable_rotor ' ]] || fail "another status: $(<map/map.csv)"
expect_contains stdout '1  status unstable_rotor'
# Nobody who wants quiet is warned.
expect_exit 0 "${turning[@]}" --output quiet --quiet
expect_empty stderr

# Cross-coupled bearings of a rotor kit, refined map and axis over a key: the warning looks at what is swept.
kit=("$top/configs/rotor_kit.yaml" --set rotor.modes=2 --set response.max_revolutions=130
  --set 'sweep={speed_hz: {values: [70]}, eccentricity_m: 1.0e-6, x: {keys: [rotor.supports.0.stiffness_xy_n_per_m, rotor.supports.0.stiffness_yx_n_per_m], factors: [1, -1], values: [0, 1.0e+4]}}')
expect_exit 0 "${kit[@]}" --check
expect_contains stderr 'warning: unstable rotor: at 1 of 2 speeds looked at'
# A stable rotor is no news.
expect_exit 0 "$minimal" --check
expect_empty stderr

# The sister programs look at the speeds that they are asked for.
spun=("$minimal" --set rotor.rotating_damping_ratio=0.05 --output sister)
expect_warning_of() {
  local program=$1
  shift
  "$(dirname "$rubsweep")/$program" "${spun[@]}" "$@" >stdout 2>stderr </dev/null || true
  expect_contains stderr "$program: warning: unstable rotor: at"
}
expect_warning_of rubtrace --speed-hz 90 --whirl-ratio 0.4 --revolutions 200
expect_warning_of rubtrace --run-up 80:90:100 --eccentricity-m 1e-5
expect_warning_of rubtrace --run-up 80:90:100 --eccentricity-m 1e-5 --with-stops
expect_warning_of rubbench --cell 90,0.4 --turns 6 --repeats 1 --labels 0x0 --tolerances 1e-4 --steppers dopri5
expect_warning_of rubbranch --cell 90,0.4
