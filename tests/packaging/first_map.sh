#!/bin/sh
# First minutes of somebody who has installed rubsweep and nothing else: first_map.sh EXAMPLES FORMATS, in an empty
# directory, with the programs in PATH. Draws where FORMATS is not empty: endings of pictures.
set -eu
examples=$1 formats=$2

run() {
  echo "\$ $*"
  "$@" 2>&1
}
holds() {
  [ -s "$1" ] || { echo "$1 is missing or empty"; exit 1; }
}

[ -z "$(ls -A)" ] || { echo "$PWD is not empty"; exit 1; }
cp "$examples/minimal.yaml" my.yaml
sed -i 's/count: 6/count: 8/' my.yaml
run rubsweep --version
run rubsweep my.yaml --check
run rubsweep my.yaml --output map --report --quiet
holds map/map.csv
holds map/config.yaml
holds map/report.html
grep -q '<svg\|<canvas' map/report.html
[ "$(grep -vc '^#' map/map.csv)" = 33 ] || { echo 'not 32 cells'; exit 1; }
run rubsweep --verify map
run rubtrace my.yaml --speed-hz 70 --whirl-ratio 0.4 --output orbit
holds orbit/trajectory.csv
for format in $formats; do
  run rubsweep my.yaml --output map --figure "map.$format" --quiet
  run rubplot trace orbit --output "orbit.$format"
  holds "map.$format"
  holds "orbit.$format"
done
for program in rubsweep-compare rubbench rubline rubbasin rubbranch rubdata rubdiagnose rubfit rubreport rubscope ringstab; do
  "$program" --help >help.txt
  holds help.txt
done
# Configurations that lie beside others, with bases above them.
for one in "$examples"/*.yaml "$examples"/*/*.yaml; do
  case $one in
    */stop.yaml) continue ;; # a part of others
    */ring_*) checked=ringstab ;;
    */recordings/candidates.yaml) continue ;; # what rubdiagnose asks about, beside a recording
    */recordings/*) checked=rubdata ;;
    *) checked=rubsweep ;;
  esac
  "$checked" "$one" --check --quiet || { echo "$one: not accepted by $checked"; exit 1; }
done
