#!/usr/bin/env bash
# measured_run_up.sh TABLE.csv [DIRECTORY]: the fits of docs/validation.md to the measured run-up of an RK-4 rotor kit.
# TABLE.csv has the columns rpm, um and deg, speed and 1X of the one probe: of analysis/fig_data/runup_bode.csv of
# github.com/M-Nouioua/rk4-rotor-unbalance-estimation, amplitudes there in mils times 25.4. Results go to DIRECTORY
# (results/measured_run_up), rubfit comes from build/release/apps. Some minutes.
set -euo pipefail
export LC_ALL=C.UTF-8
if (($# < 1 || $# > 2)); then
  echo "usage: measured_run_up.sh TABLE.csv [DIRECTORY]" >&2
  exit 2
fi
scripts=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
rubfit=$(realpath "$scripts/../build/release/apps/rubfit")
table=$(realpath "$1")
directory=${2:-$scripts/../results/measured_run_up}
mkdir -p "$directory"
cd "$directory"

awk -F, '/^#/ { next } /^rpm/ { print "speed_hz,sensor_0_amplitude_m,sensor_0_phase_deg"; next }
  { printf "%.6f,%.6e,%s\n", $1 / 60, 1e-6 * $2, $3 }' "$table" >steady.csv

# No stop is touched, but a configuration has one.
rest='stops: [{kind: one_side, angle_deg: 90, clearance_m: 1.0e-3, stiffness_n_per_m: 2.0e6, restitution: 0.7, contact_radius_m: 0.005'
sweep='sweep: {speed_hz: {values: [70]}, whirl_ratio: {values: [0.5]}}
output: {directory: out}'
cat >one_mode.yaml <<END
rotor: {kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 27.5, damping_ratio: 0.02}
$rest}]
$sweep
END
# Two equal discs on a 10 mm shaft, 560 mm between bearings whose stiffness differs in x and y.
cat >two_modes.yaml <<END
rotor:
  kind: rotor_kit
  shaft: [{length_m: 0.56, outer_diameter_m: 0.01, youngs_modulus_pa: 2.06e11, shear_modulus_pa: 7.92e10, density_kg_per_m3: 7850}]
  discs:
    - {position_m: 0.12, mass_kg: 0.8, polar_inertia_kg_m2: 5.6e-4, diametral_inertia_kg_m2: 3.2e-4}
    - {position_m: 0.44, mass_kg: 0.8, polar_inertia_kg_m2: 5.6e-4, diametral_inertia_kg_m2: 3.2e-4}
  supports:
    - {position_m: 0.0, stiffness_x_n_per_m: 1.0e5, stiffness_y_n_per_m: 1.4e5}
    - {position_m: 0.56, stiffness_x_n_per_m: 1.0e5, stiffness_y_n_per_m: 1.4e5}
  sensors: [{position_m: 0.25, angle_deg: 45}]
  damping_ratio: 0.02
  modes: 1
  elements: 6
$rest, position_m: 0.28}]
$sweep
END
# The same with a bow to be found.
sed 's/^  elements: 6/  bow: {mode: 1, amplitude_m: 1.0e-7, phase_deg: 0}\n&/' two_modes.yaml >bow.yaml

# fit NAME CONFIGURATION OPTION...: says what it finds.
fit() {
  local name=$1 config=$2
  shift 2
  echo "== $name"
  "$rubfit" "$config" --ramp steady.csv --run-out "$@" --output "$name" || true
}

common=(--fit eccentricity_m=1e-8:7e-7:1e-4 --fit mark_deg=-180:-66:180)
one=("${common[@]}" --fit rotor.natural_frequency_hz=25:27:30 --fit rotor.damping_ratio=0.002:0.015:0.2)
two=("${common[@]}" --fit rotor.supports.0.stiffness_x_n_per_m=2e4:2e5:1e7 --fit rotor.supports.0.stiffness_y_n_per_m=2e4:7e5:1e7
  --fit rotor.damping_ratio=0.001:0.0144:0.2 --fit rotor.sensors.0.angle_deg=-90:12.4:90)
fit one_mode one_mode.yaml "${one[@]}" --rate-hz-per-s 3.7
fit one_mode_rate_free one_mode.yaml "${one[@]}" --rate-hz-per-s 3.7 --fit rate_hz_per_s=2:3.7:6
for turns in 0 2 4; do
  fit "two_modes_$turns" two_modes.yaml "${two[@]}" --rate-hz-per-s 3.8 --window-turns "$turns"
done
fit bow bow.yaml "${two[@]}" --rate-hz-per-s 3.8 --window-turns 2 --fit rotor.bow.amplitude_m=0:5e-7:1e-5 \
  --fit rotor.bow.phase_deg=-180:0:180
