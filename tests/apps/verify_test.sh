#!/usr/bin/env bash
# rubsweep --verify: whether a directory of results is whole and belongs together. Arguments 4 to 7: rubtrace, rubbranch,
# ringstab, rubreport.
source "$(dirname "$0")/support.sh"
rubtrace=$4 rubbranch=$5 ringstab=$6 rubreport=$7
map=("$top/configs/benchmark/one_side.yaml" --quiet --threads 1
  --set 'sweep={speed_hz: {from: 70, to: 80, count: 3}, whirl_ratio: {values: [0.3, 0.4]}}')
expect_exit 0 "${map[@]}" --output map
"$rubbranch" --map map --quiet --threads 1 || fail 'no families'
"$rubreport" map --quiet --threads 1 || fail 'no report'

# expect_whole DIRECTORY FILE...
expect_whole() {
  expect_exit 0 --verify "$1"
  [[ $(<stdout) == "$1: whole: ${*:2}" ]] || fail "another list of files"
}
expect_whole map boundaries.csv contradictions.csv edges.csv families.csv map.csv config.yaml report.html
expect_empty stderr
expect_exit 0 --verify map --quiet
expect_empty stdout
expect_exit 1 --verify map --threads 2
expect_contains stderr '--verify: is asked for alone, allowed: without --threads'
expect_exit 1 "$minimal" --verify map
expect_exit 3 --verify nowhere
mkdir empty
expect_exit 7 --verify empty

# expect_fault TEXT COMMAND...: the copy of the map that the command changed is not whole, and why.
expect_fault() {
  rm -rf copy
  cp -r "$source" copy
  (cd copy && "${@:2}") >/dev/null
  expect_exit 7 --verify copy
  expect_empty stdout
  expect_contains stderr "$1"
}
source=map
expect_fault 'copy/map.csv: is not as it was written: its last line has no end' truncate -s -60 map.csv
expect_fault 'copy/map.csv: is not as it was written' sed -i '$s/ok/OK/' map.csv
expect_fault 'copy/edges.csv: is not as it was written' sed -i '$s/,/;/' edges.csv
expect_fault 'copy/families.csv: is not as it was written: its checksum is missing' sed -i '/^# sha256/d' families.csv
expect_fault 'edges.csv: is missing, it was written with boundaries.csv' rm edges.csv
expect_fault 'config.yaml: is missing' rm config.yaml
expect_fault 'config.yaml: is not the one of map.csv' sed -i 's/mass_kg: 0.8/mass_kg: 0.9/' config.yaml
expect_fault 'report.html: is cut off' truncate -s -60 report.html
expect_fault 'report.html: belongs to another map' sed -i "s/$(sed -n 's/^# digest //p' map/map.csv)/other/g" report.html
# Whole, of another study.
expect_exit 0 "${map[@]}" --set rotor.mass_kg=0.9 --output other
expect_fault 'boundaries.csv: belongs to another study than map.csv' cp ../other/map.csv ../other/config.yaml .
# Without checksums, as earlier versions wrote it, by what the rows say.
earlier() { sed -i -e '/^# format/d' -e '/^# sha256/d' "$1"; }
expect_earlier() { expect_fault "$1" bash -c "$(declare -f earlier); earlier map.csv; $2"; }
expect_earlier 'there is no row of speed_hz 80, whirl_ratio 0.4' "sed -i '\$d' map.csv"
expect_earlier 'is there twice' "sed -i '\$p' map.csv"
expect_earlier 'is no cell of its configuration' "sed -i '\$s/^80/81/' map.csv"
expect_earlier "is no class of a motion" "sed -i '\$s/^\([^,]*,[^,]*,[^,]*,\)[a-z_]*/\1humming/' map.csv"
rm -rf copy
cp -r map copy
earlier copy/map.csv
expect_exit 0 --verify copy
expect_contains stderr 'map.csv: has no checksum, it is of an earlier version'

# Results of other programs.
"$rubtrace" "$minimal" --speed-hz 90 --whirl-ratio 0.6 --revolutions 70 --quiet --output trace || fail 'no trace'
expect_whole trace events.csv motion.csv section.csv spectrum.csv trajectory.csv config.yaml
source=trace
expect_fault 'section.csv: is missing, it was written with events.csv' rm section.csv
expect_fault 'trajectory.csv: is not as it was written' sed -i '300s/1/2/' trajectory.csv
"$ringstab" "$top/configs/ring/figure10.yaml" --set speed_rpm.count=5 --quiet --output ring || fail 'no ring'
expect_exit 0 --verify ring
expect_contains stdout config.yaml
source=ring
expect_fault 'onsets.csv: is not as it was written' sed -i '$s/,/;/' onsets.csv
expect_fault 'config.yaml: is not the one of' sed -i 's/^friction_coefficient: .*/friction_coefficient: 0.01/' config.yaml
"$ringstab" --verify ring >stdout || fail 'the ring is not whole'
expect_contains stdout 'ring: whole: '
"$ringstab" --verify map 2>stderr && fail 'a map is no ring'
expect_contains stderr 'config.yaml'

# A map that is gone leaves what was made of it without ground; files that have no place for a sum have it in the tables.
source=map
expect_fault 'map.csv: is missing, the map of boundaries.csv' rm map.csv
expect_fault 'report.html: is not as it was written' sed -i '5s/a/b/' report.html
expect_exit 0 "$top/configs/rotor_kit.yaml" --export-matrices matrices --quiet
expect_exit 0 --verify matrices
source=matrices
expect_fault 'mass.mtx: is not as it was written' sed -i '5s/[1-8]/9/' mass.mtx
# Neither a file of unknown origin nor ends of lines of another system are damage; nobody waits at a pipe.
cp -r map guests
(cd guests && printf 'a;a\n1;2\n' >measured.csv && mkfifo pipe.csv && ln -s /dev/full full.csv)
sed -i 's/$/\r/' guests/map.csv guests/edges.csv guests/config.yaml
expect_exit 0 --verify guests
expect_contains stdout 'guests: whole: '

# An unfinished map, and a refined one.
killed_at 10 killed "$top/configs/benchmark/one_side.yaml" --quiet
expect_exit 7 --verify killed
expect_contains stderr 'map.journal: the map is not finished'
expect_exit 0 "${map[@]}" --set sweep.refine.levels=1 --output refined
expect_whole refined map.csv painted.csv config.yaml
source=refined
expect_earlier 'lacks' "sed -i '\$d' map.csv"
exec 9>map/map.lock
flock 9
expect_exit 6 --verify map
