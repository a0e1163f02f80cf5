#!/usr/bin/env bash
# rotor_kit.sh [DIR]: the experiment on a rotor kit, as Ishibashi & Kawai describe it in section 5, by simulation:
# impulse and run-up identify the rotor (1 ms samples with noise), then it rubs at 70 rev/s after a kick. Draws
# results/figures/rotor_kit_{identification,rub,map}.png and .svg and writes the reports reduction.txt,
# identification.txt and rub.txt into DIR (default results/rotor_kit). A map that is there is not computed again.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")
# Absolute names: to gnuplot others may be commands.
directory=$(realpath -ms -- "${1:-$top/results/rotor_kit}")
figures=$top/results/figures
config=$top/configs/rotor_kit.yaml
for program in rubsweep rubtrace; do
  [[ -x $top/build/release/apps/$program ]] ||
    { echo "rotor_kit.sh: no $program; cmake --preset release && cmake --build --preset release" >&2; exit 1; }
done
rubsweep=$top/build/release/apps/rubsweep rubtrace=$top/build/release/apps/rubtrace

mkdir -p "$directory"
"$rubsweep" "$config" --explain | tee "$directory/reduction.txt"
noise_m=2e-6
{
  echo '-- impulse at standstill, stops left out; 1 ms samples, noise of 2 um'
  "$rubtrace" "$config" --free-response --duration-s 1 --noise-m "$noise_m" --output "$directory/free_response"
  echo '-- run-up, 1 Hz/s, stops left out'
  "$rubtrace" "$config" --run-up 10:60:1 --eccentricity-m 2e-5 --noise-m "$noise_m" --output "$directory/run_up"
} | grep -v '^files ' | tee "$directory/identification.txt"
echo '-- rub at 70 rev/s, with the same readings of the sensors every 1 ms'
"$rubtrace" "$config" --speed-hz 70 --whirl-ratio 0.6 --last-revolutions 128 --noise-m "$noise_m" --output "$directory/rub" |
  tee "$directory/rub.txt"

# found EXPERIMENT QUANTITY: its value and sensor.
found() { python3 "$here/analysis/identification.py" "$directory/$1/identification.csv" "$2"; }
read -r natural_frequency_hz _ < <(found free_response natural_frequency_hz)
read -r damping_ratio sensor < <(found free_response damping_ratio)
read -r critical_speed_hz _ < <(found run_up critical_speed_hz)
mkdir -p "$figures"
gnuplot -d -c "$here/rotor_kit.gp" "$directory" "$figures/rotor_kit_identification" "$sensor" "$natural_frequency_hz" \
  "$damping_ratio" "$critical_speed_hz"
"$here/trace.sh" "$directory/rub" "$figures/rotor_kit_rub" 'Rotor kit against a rub screw, the shaft as the sensors beside the disc see it: exact, and read every 1 ms' -20

map=$directory/map.csv
# 4: done, but some cells failed; the figure shows which.
[[ -e $map ]] || "$rubsweep" "$config" --output "$directory" || (($? == 4))
NATURAL_FREQUENCY_HZ=$natural_frequency_hz "$here/domain_map.sh" "$map" "$figures/rotor_kit_map" \
  'Rub domains of the rotor kit after a kick'
