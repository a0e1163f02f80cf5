#!/usr/bin/env bash
# Motions of a rotor in a ring, by the columns that tell them apart: forward circle, oval, chaos, backward whip.
source "$(dirname "$0")/support.sh"

cat >ring.yaml <<'YAML'
rotor: {kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: 0.04}
stops:
  - kind: annular
    clearance_m: 1.0e-3
    stiffness_n_per_m: 2.0e6
    restitution: 0.5
    contact_radius_m: 0.0375
    friction: {stribeck: [0, 0, 0, 0.02, 100, 0]}
    casing: {mass_kg: 0.05, stiffness_n_per_m: 5.0e5, damping_ratio: 1}
kick: {force_n: 150, duration_s: 0.005}
sweep: {speed_hz: {values: [60]}, whirl_ratio: {values: [0.5]}}
output: {directory: out}
YAML

# column NAME: of the only row of out/map.csv.
column() { cells out/map.csv "$1"; }

# expect_motion SPEED WHIRL_RATIO 'CLASS ORDER ORBIT WHIRL PROOF STATUS' [ARGUMENT]...
expect_motion() {
  local speed=$1 ratio=$2 expected=$3
  shift 3
  expect_exit 0 ring.yaml --output out --fresh --quiet \
    --set "sweep={speed_hz: {values: [$speed]}, whirl_ratio: {values: [$ratio]}}" "$@"
  local found
  found=$(cells out/map.csv class order orbit whirl proof status | tr ',' ' ')
  [[ $found == "$expected" ]] || fail "$speed Hz, whirl ratio $ratio: $found, expected $expected"
}

# expect_between COLUMN LOW HIGH
expect_between() {
  [[ $(count_rows out/map.csv "$1 != '' and $2 <= $1 <= $3") == 1 ]] ||
    fail "$1 is '$(column "$1")', expected $2 to $3"
}

# expect_none COLUMN...
expect_none() {
  local name
  for name in "$@"; do
    [[ -z $(column "$name") ]] || fail "$name is '$(column "$name")', expected nothing"
  done
}

expect_motion 60 0.5 'synchronous 1 circle forward floquet_observed ok'
expect_none comb_spacing lyapunov_per_revolution
expect_between dominant_order 1 1

expect_motion 165 0.6 'quasi_periodic  oval forward floquet_observed ok'
expect_between comb_spacing 0.6123 0.6125
expect_between dominant_order 0.3875 0.3877
expect_none lyapunov_per_revolution

expect_motion 132 0.2737 'chaotic  oval forward observed ok'
expect_none comb_spacing
expect_between lyapunov_per_revolution 0.16 0.22

# Dry whip: 1 - comb_spacing is its own frequency over the shaft's, from Im (1 + i mu)(1 / Z_rotor + 1 / Z_casing) = 0.
whip=(--set 'stops.0.friction={stribeck: [0, 0, 0, 0.1, 100, 0]}' --set stops.0.casing.damping_ratio=0.1
  --set rotor.damping_ratio=0.02 --set kick.force_n=200 --set response.max_revolutions=300)
expect_motion 60 0 'quasi_periodic  circle backward observed ok' "${whip[@]}"
expect_none order lyapunov_per_revolution
expect_between comb_spacing 2.6856 2.6858
expect_between dominant_order -1.6858 -1.6856
expect_between contact_fraction 0.999999 1.000001

expect_exit 0 ring.yaml --explain
expect_matches stdout 'turns that touch the annular stop in$'
expect_matches stdout '^  Taylor pieces, to rounding, too$'
expect_exit 0 ring.yaml --explain --set solver.method=adaptive
expect_matches stdout '^stepper auto: rosenbrock4 \(implicit, .* where friction alone would change the slip 400 times faster'
expect_exit 0 ring.yaml --explain --set solver.method=adaptive --set 'stops.0.friction={coefficient: 0.1}'
expect_matches stdout '^stepper auto: dopri5 throughout'
expect_exit 0 ring.yaml --explain --set solver.stepper=rkf78
expect_matches stdout 'rkf78 \(order 8'

# Static friction holds on over the end of a turn that finds it sticking: a rotor on a floor sticks and slips up to 2.5 Hz,
# where its swing after breaking away no longer comes back to the speed of the surface.
expect_exit 0 "$top/configs/gallery/stick_slip.yaml" --output stick_slip --quiet
[[ $(count_rows stick_slip/map.csv 'speed_hz <= 2.5 and kind == "resting_contact"') == 0 ]] || fail 'stick-slip died out'
[[ $(count_rows stick_slip/map.csv 'speed_hz > 2.6 and kind != "resting_contact"') == 0 ]] || fail 'sliding did not settle'
