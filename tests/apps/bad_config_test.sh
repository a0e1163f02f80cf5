#!/usr/bin/env bash
# A bad configuration ends with 2 before anything is written; every problem has its line on stderr, with its place.
source "$(dirname "$0")/support.sh"

# expect_problems COUNT ARGUMENT...: whatever is asked of the program.
expect_problems() {
  local count=$1 action
  shift
  for action in --quiet --check --explain --print-config; do
    expect_exit 2 "$@" "$action"
    expect_empty stdout
    [[ $(wc -l <stderr) == "$count" ]] || fail "$action: expected $count lines on stderr"
  done
  expect_missing results
}

cat >several.yaml <<'YAML'
rotor: {kind: jeffcott, mass_kg: heavy, natural_frequency_hz: 30, damping_ratio: 0.02}
stops:
  - kind: one_side
    angle_deg: 90
    clearance_m: -1.0e-3
    stiffnes_n_per_m: 2.0e6
    restitution: 0.7
    contact_radius_m: 0.0375
sweep:
  speed_hz: {from: 50, to: 150, count: 6}
  whirl_ratio: {values: [0.2]}
output: {directory: results}
YAML
expect_problems 4 several.yaml
expect_matches stderr "^several\.yaml:1:34: rotor\.mass_kg: 'heavy' is not a number"
expect_matches stderr '^several\.yaml:3:5: stops\.0\.stiffness_n_per_m: missing'
expect_matches stderr '^several\.yaml:5:18: stops\.0\.clearance_m: -1\.0e-3 is out of range, allowed: a number > 0$'
expect_matches stderr \
  "^several\.yaml:6:5: stops\.0\.stiffnes_n_per_m: unknown key \(did you mean 'stiffness_n_per_m'\?\)"

echo 'rotor: [jeffcott' >broken.yaml
expect_problems 1 broken.yaml
expect_matches stderr '^broken\.yaml:[0-9]+:[0-9]+: not valid YAML'

: >empty.yaml
expect_problems 1 empty.yaml
expect_matches stderr '^empty\.yaml:1:1: the configuration is empty'

# Values of --set are reported under their own text.
expect_problems 1 "$minimal" --set rotor.mas_kg=1
expect_matches stderr "^--set rotor\.mas_kg=1: rotor\.mas_kg: unknown key \(did you mean 'mass_kg'\?\)"
expect_problems 1 "$minimal" --set stops.1.clearance_m=1e-3
expect_matches stderr "^--set stops\.1\.clearance_m=1e-3: stops: the list has no item '1'"
expect_problems 1 "$minimal" --set rotor.mass_kg.x=1
expect_problems 1 "$minimal" --set rotor..mass_kg=1
expect_problems 1 "$minimal" --set rotor.mass_kg
expect_problems 2 "$minimal" --set rotor.mass_kg=0 --set solver.stepper=rk4
expect_matches stderr '^--set rotor\.mass_kg=0: rotor\.mass_kg: 0 is out of range'
expect_matches stderr "^--set solver\.stepper=rk4: solver\.stepper: 'rk4' is unknown"

# A rotor kit whose shaft no machine has, or whose numbers cannot be computed together: said by --check already.
kit=$top/configs/rotor_kit.yaml
for diameter in 1e-300 1e100; do
  sed "s/outer_diameter_m: 0.01/outer_diameter_m: $diameter/" "$kit" >kit.yaml
  for action in --check --explain --quiet; do
    expect_exit 2 kit.yaml "$action" --output out
    expect_matches stderr '^kit\.yaml:10:[0-9]+: rotor\.shaft\.0\.outer_diameter_m: 1e[-+]?[0-9]+ is out of range, allowed: a number >= 1e-06 and <= 100$'
    expect_missing out
  done
done
expect_exit 2 "$kit" --set rotor.elements=1 --set 'rotor.bow={mode: 40, amplitude_m: 1e-5}' --check
expect_matches stderr 'rotor\.bow\.mode: the shaft has fewer modes that can be computed, allowed: 1 to [0-9]+$'
