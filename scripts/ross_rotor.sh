#!/usr/bin/env bash
# ross_rotor.sh FILE FROM_HZ TO_HZ POSITION_M [DIRECTORY]: a rotor from a file of ROSS to its Campbell diagram, design
# check and map of rub at a seal, POSITION_M along the shaft, with the time that each took. Its bearings must reach from
# FROM_HZ to TO_HZ. Configuration, tables and pictures go to DIRECTORY (results/ross_rotor), programs come from
# build/release/apps.
set -euo pipefail
export LC_ALL=C.UTF-8
if (($# < 4 || $# > 5)); then
  echo "usage: ross_rotor.sh FILE FROM_HZ TO_HZ POSITION_M [DIRECTORY]" >&2
  exit 2
fi
file=$(realpath "$1")
from_hz=$2 to_hz=$3 position_m=$4
programs=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../build/release/apps")
directory=${5:-$(dirname "${BASH_SOURCE[0]}")/../results/ross_rotor}
mkdir -p "$directory"
cd "$directory"

cat >rotor.yaml <<EOF
title: Rub at a seal of $(basename "$file")
rotor: {kind: ross, file: "$file", damping_ratio: 0.002, modes_up_to_hz: $(awk "BEGIN {print 4 * $to_hz}")}
stops:
  - {kind: annular, position_m: $position_m, clearance_m: 2.0e-4, stiffness_n_per_m: 5.0e7, restitution: 0.7, contact_radius_m: 0.1, friction: {stribeck: [0, 0, 0, 0.1, 100, 0]}}
kick: {force_n: 50000, duration_s: 0.002}
sweep:
  speed_hz: {from: $from_hz, to: $to_hz, count: 12}
  whirl_ratio: {from: 0.2, to: 2, count: 10}
output: {directory: map}
EOF

timed() {
  local begin=$EPOCHREALTIME
  "${@:2}"
  awk -v name="$1" -v begin="$begin" -v end="$EPOCHREALTIME" 'BEGIN {printf "%s: %.1f s\n", name, end - begin}'
}
timed "explained" "$programs/rubsweep" rotor.yaml --explain
timed "Campbell diagram" "$programs/rubtrace" rotor.yaml --campbell "$from_hz:$to_hz:59" --figure campbell.png
timed "design check" "$programs/rubtrace" rotor.yaml --design-check --figure design_check.png
timed "map" "$programs/rubsweep" rotor.yaml --fresh --figure map.png
