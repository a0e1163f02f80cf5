#!/usr/bin/env bash
# ring_figure.sh FIGURE [OUTPUT_BASENAME]: computes the panels of one published ring figure (03-07, 09-21) with ringstab
# and draws them as OUTPUT_BASENAME.png, by default results/figures/ring_figureNN.png. Without arguments draws all.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")
program=${RINGSTAB:-$top/build/release/apps/ringstab}
[[ -x $program ]] || { echo "ring_figure.sh: no $program; run scripts/test.sh" >&2; exit 1; }
if (($# == 0)); then
  for number in 03 04 05 06 07 09 10 11 12 13 14 15 16 17 18 19 20 21; do "$0" "$number"; done
  exit
fi
figure=$1
# Absolute names: to gnuplot others may be commands.
output=$(realpath -ms -- "${2:-$top/results/figures/ring_figure$figure}")
program=$(realpath -s -- "$program")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
panels=0

# panel TITLE CONFIG_STEM FROM_RPM TO_RPM REAL_LIMIT [--set KEY=VALUE]...: runs the system up to TO_RPM, so that its modes
# are named at rest, and lays curves and onsets from FROM_RPM out; the real parts are drawn between -REAL_LIMIT and
# REAL_LIMIT (0: all of them).
panel() {
  local title=$1 stem=$2 from=$3 to=$4 limit=$5 directory
  shift 5
  panels=$((panels + 1))
  directory=$work/$panels
  "$program" "$top/configs/$stem.yaml" --output "$directory" --quiet "$@" \
    --set "speed_rpm={from: 0, to: $to, count: $((from > 0 ? 4001 : 2001))}"
  python3 "$here/analysis/ring_layout.py" panel "$directory" "$from"
  printf 'title[%d] = "%s"\nfrom[%d] = %s\nto[%d] = %s\nlimit[%d] = %s\n' \
    "$panels" "$title" "$panels" "$from" "$panels" "$to" "$panels" "$limit" >>"$work/panels.gp"
}

# draw_with SCRIPT ARGUMENT...: where the data are, so that the names in the script's own commands are those written there.
draw_with() { (cd "$work" && gnuplot -d -c "$here/$1" . "$output" "${@:2}"); }
draw() { draw_with ring_panels.gp "$1" "$panels"; }

# chart NAME CONFIG_STEM [--set KEY=VALUE]...: lays the onsets of its chart out as $work/NAME.KIND and $work/NAME.couplings.
chart() {
  local name=$1 stem=$2
  shift 2
  "$program" "$top/configs/$stem.yaml" --output "$work/run" --quiet "$@"
  python3 "$here/analysis/ring_layout.py" chart "$work/run" "$work/$name"
}

mu() { echo "friction_coefficient=$1"; }
spring_mass() { echo "{kind: spring_mass, angle_deg: $1, mass_kg: 100, radial_stiffness_n_per_m: 1.0e6, $2}"; }
both='tangential_stiffness_n_per_m: 1.0e6'
radial='motion: radial'

case $figure in
  03)
    panel 'a) µ = 0.01' ring_figure03 0 500 0 --set "$(mu 0.01)"
    panel 'b) zoom of a' ring_figure03 140 250 1 --set "$(mu 0.01)"
    panel 'c) µ = 0.1' ring_figure03 0 500 0 --set "$(mu 0.1)"
    panel 'd) zoom of c' ring_figure03 140 250 2 --set "$(mu 0.1)"
    draw 'A radial stiffness rubs on the ring'
    ;;
  04)
    panel 'a) µ = 0.01' ring_figure04 0 1500 0 --set "$(mu 0.01)"
    panel 'b) zoom of a' ring_figure04 140 180 1 --set "$(mu 0.01)"
    panel 'c) µ = 0.1' ring_figure04 0 1500 0 --set "$(mu 0.1)"
    panel 'd) zoom of c' ring_figure04 140 180 1 --set "$(mu 0.1)"
    draw 'A mass rubs on the ring'
    ;;
  05)
    panel 'a) ω_r = 100 rad/s, µ = 0.01' ring_figure05 0 1000 0
    panel 'b) zoom of a' ring_figure05 0 700 0.2
    panel 'c) ω_r = 31.6 rad/s, µ = 0.01' ring_figure05 0 1000 0 --set loads.0.radial_stiffness_n_per_m=1e5
    panel 'd) zoom of c' ring_figure05 0 350 0.05 --set loads.0.radial_stiffness_n_per_m=1e5
    draw 'A radial spring-mass rubs on the ring'
    ;;
  06)
    panel 'a) ω_r = 100 rad/s, µ = 0.1' ring_figure05 0 1000 0 --set "$(mu 0.1)"
    panel 'b) zoom of a' ring_figure05 0 700 2 --set "$(mu 0.1)"
    draw 'A radial spring-mass, more friction'
    ;;
  07)
    a=$(spring_mass 60 "$radial") b=$(spring_mass 120 "$radial") c=$(spring_mass 180 "$radial") d=$(spring_mass 240 "$radial")
    panel 'a) one' ring_figure07 0 1000 1 --set "loads=[$a]"
    panel 'b) two, 60° apart' ring_figure07 0 1000 1 --set "loads=[$a, $b]"
    panel 'c) three, 60° apart' ring_figure07 0 1000 1 --set "loads=[$a, $b, $c]"
    panel 'd) at 60°, 120°, 240°' ring_figure07 0 1000 1 --set "loads=[$a, $b, $d]"
    draw 'Radial spring-masses, µ = 0.01'
    ;;
  09)
    panel 'a) µ = 0.01' ring_figure09 0 1500 0 --set "$(mu 0.01)"
    panel 'b) µ = 0.1' ring_figure09 0 1500 0 --set "$(mu 0.1)"
    draw 'A tangential spring-mass rubs on the ring'
    ;;
  10)
    panel 'a) µ = 0.1' ring_figure10 0 2000 0
    panel 'b) zoom' ring_figure10 0 1000 10
    draw 'A spring-mass with both motions'
    ;;
  11)
    panel 'a) k_r = 10⁷, k_t = 10⁶ N/m' ring_figure10 0 2500 0 --set loads.0.radial_stiffness_n_per_m=1e7
    panel 'b) k_r = 10⁶, k_t = 10⁷ N/m' ring_figure10 0 3500 0 --set loads.0.tangential_stiffness_n_per_m=1e7
    draw 'A spring-mass with both motions, µ = 0.1'
    ;;
  12)
    panel 'a) 60° apart' ring_figure12 0 2000 0
    panel 'b) 180° apart' ring_figure12 0 2000 0 --set loads.1.angle_deg=240
    draw 'Two spring-masses, µ = 0.1'
    ;;
  13)
    panel 'a) 60° apart' ring_figure13 0 2000 0
    panel 'b) at 60°, 120°, 240°' ring_figure13 0 2000 0 --set loads.2.angle_deg=240
    draw 'Three spring-masses, µ = 0.1'
    ;;
  14)
    panel 'k_t = 10⁷ and 10⁶ N/m' ring_figure14 0 3500 0
    draw 'Two unlike spring-masses, µ = 0.1'
    ;;
  15)
    chart n2 ring_figure15
    chart n3 ring_figure15 --set ring.nodal_diameters=3
    draw_with ring_regions.gp 'Where a second spring-mass couples with the one at 60°'
    ;;
  16)
    panel 'Zoom of figure 12a' ring_figure12 900 1250 0
    draw 'From divergence to flutter of two spring-masses, µ = 0.1'
    ;;
  17)
    beam='[{kind: beam, angle_deg: 60, radial_mass_kg: 185.66, flexural_mass_kg: 100, radial_stiffness_n_per_m: 1.175e7, tangential_stiffness_n_per_m: 1.0e6}]'
    panel 'a) spring-mass' ring_figure17 0 2500 0
    panel 'b) beam' ring_figure17 0 2500 0 --set "loads=$beam"
    draw 'A spring-mass and a beam of the same frequencies, µ = 0.1'
    ;;
  18)
    for alpha in 0 5 10 89; do
      panel "α = $alpha°" ring_figure18 0 6000 0 --set "loads.0.inclination_deg=$alpha"
    done
    draw 'An inclined beam (20 Hz) on a ring (30 Hz), µ = 0.1'
    ;;
  19)
    for alpha in 0 5 10 89; do
      panel "α = $alpha°" ring_figure18 0 2500 60 --set "loads.0.inclination_deg=$alpha"
    done
    draw 'Zooms of figure 18'
    ;;
  20 | 21)
    chart alpha ring_figure20
    draw_with ring_onset_chart.gp "$figure"
    ;;
  *)
    echo "ring_figure.sh: no figure $figure" >&2
    exit 1
    ;;
esac
