#!/usr/bin/env bash
# A rotor kit is exported as matrices of its elements and read again: the same map. Bad files write nothing.
source "$(dirname "$0")/support.sh"
kit=$top/configs/rotor_kit.yaml
small=(--set sweep.speed_hz.count=3 --set sweep.whirl_ratio.count=3 --set rotor.modes=2
  --set response.max_revolutions=200 --set rotor.damping_ratio=0.06)
exported=(mass.mtx stiffness.mtx damping.mtx gyroscopic.mtx degrees_of_freedom.csv unbalance.csv rotor.yaml)

expect_exit 0 "$kit" "${small[@]}" --export-matrices matrices
expect_empty stderr
expect_contains stdout 'files     matrices: damping.mtx degrees_of_freedom.csv'
expect_files matrices "${exported[@]}"
expect_whole_table matrices/degrees_of_freedom.csv matrices/unbalance.csv
expect_contains matrices/mass.mtx '%%MatrixMarket matrix coordinate real symmetric'
expect_contains matrices/gyroscopic.mtx '%%MatrixMarket matrix coordinate real skew-symmetric'
expect_exit 0 --verify matrices

expect_exit 0 "$kit" "${small[@]}" --output typed --quiet
expect_exit 0 matrices/rotor.yaml --output read --quiet
[[ $(rows typed/map.csv | wc -l) == 9 ]] || fail 'not nine cells'
expect_same <(rows typed/map.csv) <(rows read/map.csv)
# A configuration that is written is complete: it needs none of the files.
cp read/config.yaml alone.yaml
rm -r matrices
expect_exit 0 alone.yaml --output again --quiet
expect_same <(rows read/map.csv) <(rows again/map.csv)
expect_exit 0 alone.yaml --explain
expect_contains stdout 'rotor: matrices of 116 degrees of freedom at 29 nodes along 0.46 m'
expect_contains stdout '  stiffness: symmetric'
expect_contains stdout '  gyroscopic: skew-symmetric, times the speed'

expect_exit 2 "$kit" --set 'rotor.bow={mode: 1, amplitude_m: 1e-4}' --export-matrices none
expect_contains stderr 'rotor.bow: is a line of the shaft without load and cannot be said by matrices'
expect_missing none
expect_exit 2 "$minimal" --export-matrices none
expect_contains stderr 'a Jeffcott rotor has no finite elements'
expect_missing none
expect_usage_error '--export-matrices runs nothing' "$kit" --export-matrices none --explain
expect_exit 0 "$kit" "${small[@]}" --export-matrices matrices --quiet
expect_empty stdout
expect_usage_error '--export-matrices: rotor.yaml would replace the configuration' matrices/rotor.yaml \
  --export-matrices matrices
sed -i 's/^4 4 /4 4 -/' matrices/mass.mtx
expect_exit 2 matrices/rotor.yaml --output none
expect_contains stderr 'matrices/mass.mtx:1:1: rotor.mass: has -'
expect_missing none
