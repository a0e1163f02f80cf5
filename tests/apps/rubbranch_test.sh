#!/usr/bin/env bash
# rubbranch: what it writes, what it prints and how it ends.
source "$(dirname "$0")/support.sh"
one_side=$top/configs/benchmark/one_side.yaml

# Command line.
expect_help cell along from to curve curve-from curve-to switch points map fresh threads
expect_usage_error 'a configuration file is needed'
expect_usage_error 'a cell to start from is needed' "$minimal"
expect_usage_error '--cell 75: allowed: SPEED_HZ,UNBALANCE' "$minimal" --cell 75
expect_usage_error '--cell 0,0.4: allowed: SPEED_HZ,UNBALANCE' "$minimal" --cell 0,0.4
expect_usage_error '--from and --to: allowed' "$minimal" --cell 70,0.4 --from 80 --to 60
expect_usage_error '--points: allowed' "$minimal" --cell 70,0.4 --points 1

# Configuration, cells and files that cannot be had.
expect_exit 2 "$minimal" --set rotor.mass_kg=-1 --cell 70,0.4
expect_exit 2 "$minimal" --cell 70,0.4 --along stops.0.stifness_n_per_m
expect_contains stderr 'the configuration has no such number'
expect_exit 2 "$minimal" --cell 70,0.4 --from 80 --to 90
expect_contains stderr 'must hold that of the cell, 70'
expect_exit 4 "$minimal" --cell 70,0.4 --set kick.force_n=1
expect_contains stderr 'its motion is non_contact; nothing is written'
expect_missing results/minimal_branch/branch.csv
expect_exit 3 no_such_file.yaml --cell 70,0.4
rm -rf results

# The half orbit of set A: closed between two folds, the same from two cells.
expect_exit 0 "$one_side" --cell 75,0.4 --output first
expect_empty stderr
expect_files first branch.csv config.yaml events.csv
expect_matches stdout '^branch 0  order 2, speed_hz .* ends closed and closed$'
[[ $(count_rows first/events.csv "kind == 'fold'") == 2 ]] || fail 'not two folds'
[[ $(count_rows first/branch.csv "order != 2 or feasible != 1") == 0 ]] || fail 'an orbit of another order'
[[ $(count_rows first/branch.csv "(floquet_modulus < 1) != (stable == 1)") == 0 ]] || fail 'stability and multipliers differ'
expect_exit 0 "$one_side" --cell 84,0.4 --output second
folds() { cells "$1/events.csv" kind parameter | awk -F, '$1 == "fold" { printf "%.9g\n", $2 }' | sort; }
expect_same <(folds first) <(folds second)

# Along the unbalance, with the orbit of twice the period, and along any number of the configuration.
expect_exit 0 "$one_side" --cell 4500rpm,0.4 --output minutes
expect_same minutes/branch.csv first/branch.csv
expect_exit 0 "$one_side" --cell 75,0.3 --along whirl_ratio --switch --output doubled
expect_matches stdout '^branch 1  order 4, whirl_ratio .* ends period_halving and left_range$'
expect_exit 0 "$one_side" --cell 75,0.4 --along stops.0.casing.mass_kg --from 0.04 --to 0.06 --output casing
expect_matches stdout '^branch 0  order 2, stops.0.casing.mass_kg 0.04 to 0.06, .* ends left_range and left_range$'

# On axes over keys --cell says a place on the two that have several values.
masses='x: {key: stops.0.casing.mass_kg, values: [0.05, 0.055]}'
speeds='speed_hz: {values: [74, 75]}, whirl_ratio: {values: [0.4]}'
expect_exit 0 "$one_side" --set "sweep={$speeds, $masses}" --cell 75,0.055 --from 74 --to 76 --output on_axes
expect_exit 0 "$one_side" --set stops.0.casing.mass_kg=0.055 --cell 75,0.4 --from 74 --to 76 --output written
expect_same <(grep -v '^#' on_axes/branch.csv) <(grep -v '^#' written/branch.csv)
expect_exit 0 "$one_side" --set "sweep={$speeds, $masses}" --set stops.0.casing.mass_kg=0.055 --cell 75,0.4 \
  --from 74 --to 76 --output held
expect_same <(grep -v '^#' held/branch.csv) <(grep -v '^#' written/branch.csv)
expect_exit 2 "$one_side" --set "sweep={$speeds, $masses, y: {key: kick.force_n, values: [100, 200]}}" --cell 75,0.055
expect_contains stderr '--cell: X,Y say the place on two axes of the sweep, and 3 of its axes have several values'

# The parameter of a branch does not change an orbit: the same one by the speed of another configuration.
expect_exit 0 "$one_side" --cell 75,0.4 --along kick.force_n --from 190 --to 210 --output kick
[[ $(cells kick/branch.csv floquet_modulus | awk '{ printf "%.6f\n", $1 }' | sort -u | wc -l) == 1 ]] ||
  fail 'the kick changes an orbit that is there without it'

# An oval in a centred annulus, whose period is none of the shaft: the orbit and the multipliers that a map proves.
annulus=$top/configs/benchmark/annulus.yaml
expect_exit 0 "$annulus" --cell 180,0.6 --from 179.5 --to 180.5 --output oval
expect_matches stdout '^branch 0  order 1, speed_hz 179.5 to 180.5, .* ends left_range and left_range$'
"${rubsweep%/*}/rubsweep" "$annulus" --quiet --output cell \
  --set 'sweep={speed_hz: {values: [180]}, whirl_ratio: {values: [0.6]}}' || fail 'no map'
read -r spacing modulus <<<"$(cells cell/map.csv comb_spacing floquet_modulus | tail -n 1 | tr , ' ')"
near() { echo "abs($1 - $2) < 1e-7"; }
[[ $(count_rows oval/branch.csv \
  "arclength == 0 and $(near 1/period_turns "$spacing") and $(near floquet_modulus "$modulus")") == 1 ]] ||
  fail "not the oval with comb spacing $spacing and modulus $modulus"

# expect_figure PICTURE DATA NAME TEXT...: rubplot draws out/NAME of it with these texts, where there is gnuplot.
expect_figure() {
  command -v gnuplot >/dev/null || return 0
  rubplot "$1" "$2" --output "out/$3" >stdout 2>stderr || fail "$1 failed"
  expect_empty stdout
  expect_empty stderr
  local text
  for text in "${@:4}"; do expect_contains "out/$3.svg" "$text"; done
}
expect_figure branch doubled picture 'order 4, unstable' 'period-doubling'

# A curve in two parameters: folds that stay folds, and the plane that must be one.
expect_usage_error '--curve-from and --curve-to belong to --curve' "$one_side" --cell 75,0.4 --curve-to 0.5
expect_exit 2 "$one_side" --cell 75,0.4 --along whirl_ratio --curve eccentricity_m
expect_contains stderr 'is the parameter of --along whirl_ratio'
expect_exit 2 "$one_side" --cell 75,0.4 --curve whirl_ratio --curve-from 0.5
expect_contains stderr 'must hold that of the cell, 0.4'
expect_exit 0 "$one_side" --cell 75,0.4 --curve whirl_ratio --curve-from 0.3 --curve-to 0.5 --output plane
expect_empty stderr
expect_files plane branch.csv config.yaml curves.csv events.csv meetings.csv
expect_matches stdout '^curve 0   fold of order 2, speed_hz .* ends left_range and left_range$'
[[ $(count_rows plane/curves.csv "kind != 'fold' or abs(multiplier_1_re - 1) > 1e-8 or error > 1e-10") == 0 ]] ||
  fail 'no fold'
expect_figure curves plane plane 'fold'

# All families of a map: beside it, and the edges between its cells.
expect_usage_error '--map takes the configuration of the map' "$minimal" --map results
expect_usage_error '--along belongs to a cell, not to --map' --map results --along whirl_ratio
expect_usage_error '--points belongs to a cell, not to --map' --map results --points 10
expect_usage_error '--cell: 4500 Hz is over 100 times the lowest natural frequency' "$minimal" --cell 4500,0.4
expect_usage_error 'gravity_m_per_s2 is 0 here, which says no range' "$minimal" --cell 70,0.4 --along gravity_m_per_s2
expect_exit 2 "$minimal" --cell 70,0.4 --along response.max_revolutions
expect_contains stderr '--along response.max_revolutions: is no part of the machine'
expect_exit 3 --map no_such_map
"${rubsweep%/*}/rubsweep" "$one_side" --quiet --output map \
  --set 'sweep={speed_hz: {from: 60, to: 95, count: 8}, whirl_ratio: {values: [0.3, 0.4]}}' || fail 'no map'
expect_exit 0 --map map --threads 2
expect_empty stderr
expect_files map boundaries.csv config.yaml contradictions.csv edges.csv families.csv map.csv
expect_contains stdout 'the orbits of 0 were not found again'
[[ $(header_of map/boundaries.csv) == family,kind,speed_hz,whirl_ratio ]] || fail 'another header'
expect_same <(grep '^# digest ' map/boundaries.csv) <(grep '^# digest ' map/map.csv)
[[ $(count_rows map/families.csv "order == 2 and hits == 1 and cells_existing >= cells_reached") == 1 ]] || fail 'no half orbit'
# Its fold at a whirl ratio of 0.4 is the one that the branch of a single cell has.
upper=$(folds first | tail -n 1)
grep -q "^0,fold,${upper%?}" map/boundaries.csv || fail "no fold at $upper in map/boundaries.csv"
[[ $(count_rows map/edges.csv "attribution not in ('ceases', 'basin', 'unresolved')") == 0 ]] || fail 'another attribution'
[[ $(count_rows map/edges.csv "label_1 == label_2") == 0 ]] || fail 'an edge between equal labels'
expect_contains stdout '0 labels contradict the domains of the families'
expect_figure map map/map.csv map 'orbit ends in a fold'
expect_same_families() {
  for file in boundaries.csv contradictions.csv edges.csv families.csv; do expect_same "$1/$file" "$2/$file"; done
}
cp -r map once
expect_exit 0 --map map --threads 1 --quiet
expect_empty stdout
expect_same_families map once

# Circles and ovals of an annular map. The circle of full annular rub ends where its closed form folds: as a quadratic in
# the approach, (unbalance)^2 has its minimum at 75.858194951125 Hz for a whirl ratio of 0.7.
"${rubsweep%/*}/rubsweep" "$annulus" --quiet --output annular \
  --set 'sweep={speed_hz: {values: [60, 80, 180, 200]}, whirl_ratio: {values: [0.5, 0.7]}}' || fail 'no map'
expect_exit 0 --map annular --threads 2
expect_contains stdout '0 labels contradict the domains of the families'
[[ $(count_rows annular/families.csv "closing == 'with_the_shaft' and order == 1 and hits == 0") == 1 ]] || fail 'no circle'
[[ $(count_rows annular/families.csv "closing == 'in_the_turning_frame'") -ge 1 ]] || fail 'no oval'
[[ $(count_rows annular/boundaries.csv "kind == 'fold' and whirl_ratio == 0.7 and abs(speed_hz - 75.858194951125) < 1e-9") == 1 ]] ||
  fail 'the circle does not end in its fold'

# A refined map does not hold every cell.
"${rubsweep%/*}/rubsweep" "$minimal" --quiet --output refined --set 'sweep.refine={levels: 1}' || fail 'no map'
expect_exit 2 --map refined
expect_contains stderr 'sweep.refine: most cells of a refined map are not computed, allowed with --map: a map of every cell'

# However a call ends, the same command goes on, and the files are those of an undisturbed one, on any number of threads.
expect_usage_error '--fresh goes with --map' "$minimal" --cell 70,0.4 --fresh
"${rubsweep%/*}/rubsweep" "$one_side" --quiet --output wide \
  --set 'sweep={speed_hz: {from: 60, to: 95, count: 30}, whirl_ratio: {values: [0.3, 0.35, 0.4]}}' || fail 'no map'
expect_exit 0 --map wide --output whole
expect_files wide config.yaml map.csv
[[ $(count_rows whole/contradictions.csv "side == 'inside' and finding == 'stays' and contradiction == 0") -gt 0 ]] ||
  fail 'nothing was started on the orbit'
set -m # or SIGINT would be ignored in the background
# kill_after RECORDS SIGNAL [ARGUMENT]...: kills a call as soon as so many lines of its journal are there, and, where some
# are from an earlier call, as soon as it has said that it goes on with them.
kill_after() {
  local known=false
  [[ ! -e killed/families.journal ]] || known=true
  : >stderr
  "$rubsweep" --map wide --output killed "${@:3}" >stdout 2>stderr </dev/null &
  local running=$! code=0
  until [[ -e killed/families.journal ]] && (($(grep -cE ' (settled|way|stays) ' killed/families.journal) >= $1)); do
    kill -0 "$running" 2>/dev/null || break
    sleep 0.002
  done
  until [[ $known == false || -s stderr ]]; do
    kill -0 "$running" 2>/dev/null || break
    sleep 0.002
  done
  kill -s "$2" "$running" 2>/dev/null || true
  wait "$running" 2>/dev/null || code=$?
  # A machine in a hurry may have been done before.
  [[ $code == 0 || $code == $((128 + $(kill -l "$2"))) ]] || fail "exit code $code after $2"
}
kill_after 1 INT --threads 2
expect_contains stderr 'interrupted; what was found is kept'
expect_missing killed/families.csv
kill_after 10 KILL --threads 1
kill_after 30 KILL --threads 2
expect_contains stderr 'goes on with'
expect_missing killed/families.csv
found=$(grep -cE ' (settled|way|stays) ' killed/families.journal)
((found >= 30)) || fail 'what was found is lost'
cp -r killed torn
# A line cut in the middle, and one letter that is another.
truncate -s -7 torn/families.journal
sed -i '0,/ settled /s// Settled /' torn/families.journal
cp -r torn other
expect_exit 0 --map wide --output killed --threads 1 --quiet
expect_contains stderr "goes on with $found orbits and ways"
expect_same_families killed whole
expect_files killed boundaries.csv contradictions.csv edges.csv families.csv
expect_exit 0 --map wide --output torn --threads 2
expect_contains stderr '1 damaged records; what they held is computed again'
expect_contains stderr "goes on with $((found - 2)) orbits and ways"
expect_same_families torn whole
# A full disk, seen as a limit on the size of a file.
(
  ulimit -f 8
  expect_exit 3 --map wide --output full --threads 2
)
expect_contains stderr 'full/families.journal: File too large'
expect_missing full/families.csv
expect_exit 0 --map wide --output full
expect_contains stderr 'goes on with'
expect_same_families full whole
# Nothing of it passes to another map.
"${rubsweep%/*}/rubsweep" "$one_side" --quiet --output narrow \
  --set 'sweep={speed_hz: {from: 75, to: 80, count: 2}, whirl_ratio: {values: [0.4]}}' || fail 'no map'
expect_exit 2 --map narrow --output other
expect_contains stderr 'other/families.journal: holds finished cells of another configuration'
expect_exit 0 --map narrow --output other --fresh
expect_files other boundaries.csv contradictions.csv edges.csv families.csv
mv map/config.yaml other.yaml
sed 's/mass_kg: 0.8/mass_kg: 0.9/' other.yaml >map/config.yaml
expect_exit 2 --map map
expect_contains stderr 'is no map of this configuration'
