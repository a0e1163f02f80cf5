#!/usr/bin/env bash
# measured_machine.sh [DIRECTORY]: from recordings of a machine to its map, and its rub laid over a recorded one. A
# simulated rotor kit whose numbers the fit does not know stands in for the measured machine: it is struck, run up and made
# to rub, and an instrument with noise, run-out, errors of its gains and a clock of its own records it. Recordings, tables
# and pictures go to DIRECTORY (results/measured_machine), programs come from build/release/apps. Some minutes.
set -euo pipefail
export LC_ALL=C.UTF-8
if (($# > 1)); then
  echo "usage: measured_machine.sh [DIRECTORY]" >&2
  exit 2
fi
scripts=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
programs=$(realpath "$scripts/../build/release/apps")
guess=$(realpath "$scripts/../configs/rotor_kit.yaml")
directory=${1:-$scripts/../results/measured_machine}
mkdir -p "$directory"
cd "$directory"
if compgen -G '*' >/dev/null; then
  echo "measured_machine.sh: $PWD is not empty" >&2
  exit 2
fi

# as_recorded SENSORS.csv RECORDING.csv OPTION...: what the logger has written, and a description of the instrument.
as_recorded() {
  PYTHONPATH=$scripts python3 "$scripts/analysis/as_recorded.py" "$@" --mark-deg 50 --gain-error 0.002 --clock-ppm 20
}

echo '== the machine on the bench: struck, run up, made to rub'
hidden=("$guess" --set rotor.modes=2 --quiet)
"$programs/rubtrace" "${hidden[@]}" --free-response --duration-s 1 --noise-m 1e-6 --output bench/impulse
"$programs/rubtrace" "${hidden[@]}" --run-up 22:40:4 --eccentricity-m 1.2e-5 --sample-s 2e-4 --noise-m 1e-6 --output bench/run_up
"$programs/rubtrace" "${hidden[@]}" --speed-hz 70 --whirl-ratio 0.6 --revolutions 300 --sample-s 2e-4 --noise-m 2e-6 \
  --output bench/rub
as_recorded bench/run_up/sensors.csv run_up.csv --speed-hz 22 --rate-hz-per-s 4 --run-out-um 0.5
as_recorded bench/rub/sensors.csv rub.csv --speed-hz 70
# Until then the kick dies away.
echo 'from_s: 2' >>rub.yaml

echo '== what was recorded'
"$programs/rubscope" run_up.csv --figure run_up.png
"$programs/rubscope" rub.csv

echo '== the machine from the impulse and the run-up'
"$programs/rubfit" "$guess" --set rotor.modes=2 --set rotor.damping_ratio=0.03 \
  --set rotor.supports.0.stiffness_x_n_per_m=3e4 --set rotor.supports.0.stiffness_y_n_per_m=3e4 \
  --ring-down bench/impulse/sensors.csv --from-s 0.006 --run-up run_up_scope/bode.csv --run-out \
  --fit rotor.damping_ratio --fit rotor.supports.0.stiffness_x_n_per_m --fit rotor.supports.0.stiffness_y_n_per_m \
  --fit eccentricity_m=1e-6:1e-5:1e-4 --fit mark_deg --output fit --figure fit.png

echo '== its map'
"$programs/rubsweep" fit/config.yaml --set 'sweep.speed_hz={from: 50, to: 130, count: 17}' \
  --set 'sweep.whirl_ratio={from: 0.1, to: 0.9, count: 9}' --set response.max_revolutions=300 --output map --figure map.png

echo '== its rub at 70 Hz over the recorded one'
"$programs/rubscope" rub.csv --compare fit/config.yaml --cell 70,0.6 --output over --figure over.png
