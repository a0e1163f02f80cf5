#!/bin/sh
# Transcript of the first ten minutes with an installed rubsweep: first_ten_minutes.sh SCRIPTS, in an empty directory. Each
# command is printed before what it says. SCRIPTS holds terminal_session.py.
set -eu
scripts=$1

run() {
  echo
  echo "\$ $1"
  sh -c "$1" 2>&1
}
holds() {
  [ -s "$1" ] || { echo "$1 is missing or empty"; exit 1; }
}

[ -z "$(ls -A)" ] || { echo "$PWD is not empty"; exit 1; }
run 'rubsweep --version'
run 'rubsweep --init rotor_kit > my.yaml'
cp my.yaml begun.yaml
# Another clearance, and fewer speeds.
run "sed -i -e 's/clearance_m: 5.0e-4 # 0.5 mm/clearance_m: 4.0e-4 # 0.4 mm/' -e 's/step: 500/step: 1000/' my.yaml"
diff begun.yaml my.yaml || true
rm begun.yaml
run 'rubsweep my.yaml --check'
run 'rubsweep my.yaml --explain | head -n 3'
run 'rubsweep my.yaml --output map --figure map.png --report'
holds map/map.csv
holds map/report.html
holds map.png
run 'rubtrace my.yaml --speed-rpm 7000 --whirl-ratio 0.6 --check'
run 'rubtrace my.yaml --speed-rpm 7000 --whirl-ratio 0.6 --length-unit um --output orbit --figure orbit.png'
holds orbit/trajectory.csv
holds orbit.png
run 'ls -s --block-size=1K'
echo
python3 "$scripts/terminal_session.py"
