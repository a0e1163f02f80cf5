#!/usr/bin/env bash
# The digest in map.csv tells studies apart, and only studies: not how a file is written or a program is called.
source "$(dirname "$0")/support.sh"

cat >plain.yaml <<'YAML'
rotor: {kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: 0.02}
stops:
  - {kind: one_side, angle_deg: 90, clearance_m: 0.001, stiffness_n_per_m: 2.0e6, restitution: 0.7,
     contact_radius_m: 0.0375, friction: {coefficient: 0.1}}
sweep: {speed_hz: {from: 50, to: 51, count: 2}, whirl_ratio: {values: [0.2]}}
output: {directory: plain}
YAML

cat >rewritten.yaml <<'YAML'
# The same study, written by somebody else.
output:
  directory: rewritten
sweep:
  whirl_ratio: {from: 0.2, count: 1}
  speed_hz:
    values: [5.0e1, 51]
solver: {stepper: auto}   # the default
stops:
  - friction: {coefficient: 1e-1}
    contact_radius_m: 37.5e-3
    restitution: 0.70
    stiffness_n_per_m: 2000000
    clearance_m: 1.0e-3
    angle_deg: 90.0
    kind: one_side
rotor:
  damping_ratio: 2.0e-2
  natural_frequency_hz: 30.0
  mass_kg: 0.8
  kind: jeffcott
YAML

# digest_of CONFIG [ARGUMENT]...: runs it; its digest is in `digest` from then on.
digest_of() {
  expect_exit 0 "$@" --output out --fresh
  digest=$(sed -n 's/^# digest //p' out/map.csv)
  [[ -n $digest ]] || fail 'map.csv has no digest'
}

digest_of plain.yaml
plain=$digest

# expect_same_study ARGUMENT...
expect_same_study() {
  digest_of "$@"
  [[ $digest == "$plain" ]] || fail "$*: another digest"
}
expect_same_study rewritten.yaml
expect_same_study out/config.yaml
expect_same_study plain.yaml --threads 1 --quiet --progress never
expect_same_study plain.yaml --set output.directory=elsewhere
expect_same_study plain.yaml --set rotor.mass_kg=8e-1 --set 'sweep.whirl_ratio={from: 0.2, to: 0.2, count: 1}'
expect_exit 0 plain.yaml
expect_same plain/map.csv out/map.csv

# Each of these is a study of its own.
studies=("$plain")
for change in rotor.mass_kg=0.81 rotor.damping_ratio=0.03 stops.0.clearance_m=0.0011 stops.0.restitution=0.71 \
  stops.0.friction.coefficient=0.2 stops.0.friction=none 'kick={force_n: 1, duration_s: 0.005}' gravity_m_per_s2=9.81 \
  'sweep.speed_hz={values: [50, 52]}' 'sweep.speed_hz={values: [51, 50]}' solver.relative_tolerance=1e-9 \
  response.max_revolutions=601; do
  digest_of plain.yaml --set "$change"
  for study in "${studies[@]}"; do
    [[ $digest != "$study" ]] || fail "$change: the digest of another study"
  done
  studies+=("$digest")
done
