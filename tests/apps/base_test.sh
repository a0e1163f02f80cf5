#!/usr/bin/env bash
# Files that name a base: the merged result is printed, checked, computed and kept, and stands alone afterwards.
source "$(dirname "$0")/support.sh"

mkdir -p machines studies
cat >machines/rotor.yaml <<'YAML'
rotor: {kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: 0.02}
kick: {force_n: 50, duration_s: 0.005}
YAML
cat >machines/machine.yaml <<'YAML'
base: rotor.yaml
stops:
  - {base: stop.yaml, angle_deg: 90}
sweep: {speed_hz: {from: 50, to: 150, count: 6}, whirl_ratio: {values: [0.2, 0.4]}}
output: {directory: machine}
YAML
cat >machines/stop.yaml <<'YAML'
kind: one_side
clearance_m: 0.001
stiffness_n_per_m: 2.0e6
restitution: 0.7
contact_radius_m: 0.0375
friction: {stribeck: [0, 0, 0, 0.1, 100, 0]}
YAML
cat >studies/two.yaml <<'YAML'
base: ../machines/machine.yaml
rotor: {damping_ratio: 0.03}
stops:
  - {base: ../machines/stop.yaml, angle_deg: 90}
  - {base: ../machines/stop.yaml, angle_deg: -90, friction: {coefficient: 0.2}}
kick:
sweep: {speed_hz: {values: [50, 60]}}
output: {directory: two}
YAML
cat >single.yaml <<'YAML'
rotor: {kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: 0.03}
stops:
  - {kind: one_side, angle_deg: 90, clearance_m: 0.001, stiffness_n_per_m: 2.0e6, restitution: 0.7,
     contact_radius_m: 0.0375, friction: {stribeck: [0, 0, 0, 0.1, 100, 0]}}
  - {kind: one_side, angle_deg: -90, clearance_m: 0.001, stiffness_n_per_m: 2.0e6, restitution: 0.7,
     contact_radius_m: 0.0375, friction: {coefficient: 0.2}}
sweep: {speed_hz: {values: [50, 60]}, whirl_ratio: {values: [0.2, 0.4]}}
output: {directory: two}
YAML

# The merged file is the single one, to the byte of what is printed, said and computed.
for action in --print-config --explain; do
  expect_exit 0 single.yaml "$action"
  cp stdout expected
  expect_exit 0 studies/two.yaml "$action"
  expect_same stdout expected
done
expect_exit 0 studies/two.yaml --check
[[ $(<stdout) == 'studies/two.yaml: ok, 4 cells' ]] || fail 'another number of cells'
expect_exit 0 single.yaml --output single --quiet
expect_exit 0 studies/two.yaml --quiet
expect_same two/map.csv single/map.csv

# The file beside the map needs no other one, wherever it is.
mkdir elsewhere
cp two/config.yaml elsewhere
mv machines away
expect_exit 0 elsewhere/config.yaml --output again --quiet
expect_same again/map.csv two/map.csv
! grep -q base two/config.yaml || fail 'config.yaml names a base'
expect_exit 2 studies/two.yaml --check
expect_contains stderr "studies/two.yaml:1:7: base: '../machines/machine.yaml' cannot be read: No such file or directory"
mv away machines

# --set works on the merged result.
expect_exit 0 studies/two.yaml --set stops.1.friction.coefficient=0.3 --set rotor.mass_kg=2 --print-config
expect_contains stdout 'coefficient: 0.3'
expect_contains stdout 'mass_kg: 2'
expect_exit 2 studies/two.yaml --set base=machines/machine.yaml --check
expect_matches stderr '^--set base=machines/machine\.yaml: base: an override is no file and has no base'

# A map of the merged study is nobody else's; what differs is said by key.
expect_exit 2 machines/machine.yaml --output two
expect_contains stderr 'rotor.damping_ratio'

# Problems of a base are said at its own place, and those of all files at once.
sed -i 's/mass_kg: 0.8/mass_kg: heavy/' machines/rotor.yaml
sed -i 's/damping_ratio: 0.03/dampingratio: 0.03/' studies/two.yaml
expect_exit 2 studies/two.yaml --check
expect_matches stderr "^studies/\.\./machines/rotor\.yaml:1:34: rotor\.mass_kg: 'heavy' is not a number"
expect_matches stderr "^studies/two\.yaml:2:9: rotor\.dampingratio: unknown key \(did you mean 'damping_ratio'\?\)"
[[ $(wc -l <stderr) == 2 ]] || fail 'expected two problems'

# A file that is based on itself.
echo 'base: b.yaml' >a.yaml
echo 'base: a.yaml' >b.yaml
expect_exit 2 a.yaml --check
expect_matches stderr "^b\.yaml:1:7: base: 'a\.yaml' leads back to itself"
expect_missing results
