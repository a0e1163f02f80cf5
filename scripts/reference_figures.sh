#!/usr/bin/env bash
# reference_figures.sh [FIGURE]...: the motions of the reference machine as results/figures/reference_figureNN.png and
# .svg, for 04 (rub persists after the kick), 05 (it does not), 07 (against one stop), 08 (between two), 10 (in a centred
# annulus), 13 (in one with offset), and as reference_rotor_kit what two probes see of the kit at 70 rev/s beside the
# exact motion (the published figures 15 to 17 and 19 to 21). All of them without arguments.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")

# motions FIGURE CONFIG_STEM REVOLUTIONS HEADING CELL...
motions() {
  "$here/trace_figure.sh" "reference/$2" "reference_$1" "Reference machine: $4" "$3" "" "${@:5}"
}

rotor_kit() {
  local trace=$top/results/reference/rotor_kit_70_hz
  "$top/build/release/apps/rubtrace" "$top/configs/reference/rotor_kit.yaml" --speed-hz 70 --whirl-ratio 0.5 \
    --last-revolutions 128 --sample-s 1e-3 --noise-m 2e-6 --output "$trace"
  "$here/trace.sh" "$trace" "$top/results/figures/reference_rotor_kit" \
    'Reference machine, rotor kit at 70 rev/s: exact, and as probes read it every 1 ms' -20
}

figures=("$@")
((${#figures[@]})) || figures=(04 05 07 08 10 13 rotor_kit)
for figure in "${figures[@]}"; do
  case $figure in
    04) motions figure04 figure04_one_side 40 'rub persists after the kick' 78:0.1 ;;
    05) motions figure05 figure05_one_side 40 'rub does not persist' 72:0.1 ;;
    07) motions figure07 figure07_one_side -20 'against one stop' 69:0.1 120:0.1 156:0.1 207:0.1 ;;
    08) motions figure08 figure08_both_sides -20 'between two stops' 90:0.5 135:0.1 195:0.02 ;;
    10) motions figure10 figure10_annulus -20 'in a centred annulus' 90:0.55 225:0.15 225:0.55 ;;
    13) motions figure13 figure13_annulus_offset -20 'in an annulus with offset' 90:0.7 60:0.9 57:0.7 240:0.7 ;;
    rotor_kit) rotor_kit ;;
    *)
      echo "reference_figures.sh: unknown figure '$figure', allowed: 04, 05, 07, 08, 10, 13, rotor_kit" >&2
      exit 1
      ;;
  esac
done
