#!/usr/bin/env bash
# measured_machine_test.sh TOP: scripts/measured_machine.sh finds the numbers of the machine that it hides, and draws what it
# says. Minutes. Ends with 77 where there is no gnuplot.
set -euo pipefail
export LC_ALL=C.UTF-8
top=$1
command -v gnuplot >/dev/null || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$top/scripts/measured_machine.sh" "$work/machine" >"$work/said" 2>&1 || { cat "$work/said"; exit 1; }
cd "$work/machine"

# Errors of the gains are up to 0.3 %, and the angle of the mark is known to some tenths of a degree.
awk -F, -v wrong=0 '
  function near(value, truth, room) { found++; if (value < truth - room || value > truth + room) { print $1, value; wrong = 1 } }
  $1 == "rotor.damping_ratio" { near($2, 0.02, 1e-4) }
  $1 ~ /stiffness_[xy]_n_per_m/ { near($2, 32000, 100) }
  $1 == "eccentricity_m" { near($2, 1.2e-5, 6e-8) }
  $1 == "mark_deg" { near($2, 50, 0.3) }
  END { if (found != 5) print found, "numbers"; exit wrong || found != 5 }' fit/parameters.csv
grep -q 'subharmonic 1/2' "$work/said" || { echo 'the recorded rub is another motion'; exit 1; }
for picture in run_up fit map over; do
  [[ $(stat -c %s "$picture.png") -gt 20000 ]] || { echo "$picture.png is empty"; exit 1; }
done
