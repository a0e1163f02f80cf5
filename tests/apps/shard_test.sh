#!/usr/bin/env bash
# A map computed in parts, by processes that know nothing of each other, is the same map.
source "$(dirname "$0")/support.sh"

expect_exit 0 "${quick[@]}" --output whole
for shards in 1 2 5 100; do
  for ((i = 1; i <= shards; ++i)); do
    expect_exit 0 "${quick[@]}" --output "of_$shards" --shard "$i/$shards"
    expect_contains stdout ' cells finished; when every shard is: rubsweep '
    expect_missing "of_$shards/map.csv"
  done
  expect_exit 0 "${quick[@]}" --output "of_$shards" --merge
  expect_matches stdout '^ +[0-9]+ +[0-9.]+ %  non_contact$'
  expect_same "of_$shards/map.csv" whole/map.csv
  expect_files "of_$shards" config.yaml map.csv
done

# More parts than files that a process may open unless it asks for more.
expect_exit 0 "${quick[@]}" --output many --shard 1/2
for ((i = 2; i <= 80; i += 2)); do expect_exit 0 "${quick[@]}" --output many --shard "$i/80"; done
(
  ulimit -Sn 32
  expect_exit 0 "${quick[@]}" --output many --merge
)
expect_same many/map.csv whole/map.csv

# At the same time.
for i in 1 2 3; do "$rubsweep" "${quick[@]}" --output together --shard $i/3 --threads 1 --quiet & done
wait
expect_exit 0 "${quick[@]}" --output together --merge --quiet
expect_empty stdout
expect_same together/map.csv whole/map.csv

# A part that is not there yet: the merge says so, loses nothing, and any run may finish the rest.
expect_exit 0 "${quick[@]}" --output part --shard 2/4
expect_matches part/map.shard-2-of-4.partial.csv '^59[.0-9]*,0.02,'
[[ $(rows part/map.shard-2-of-4.partial.csv | wc -l) == 24 ]] || fail 'not a quarter of the cells'
expect_whole_rows part/map.shard-2-of-4.partial.csv
expect_exit 3 "${quick[@]}" --output part --merge
expect_contains stderr 'rubsweep: nothing to merge yet: 72 of 96 cells are not finished, those of shards 1/4, 3/4, 4/4, allowed: first'
# The printed command runs as it is, whatever the names are.
cp "$minimal" "it's minimal.yaml"
hinted=("it's minimal.yaml" "${quick[@]:1}" --output 'a b')
expect_exit 0 "${hinted[@]}" --shard 1/3
sed 's/.*when every shard is: //' stdout >merge_hint
grep -q -- '--merge$' merge_hint || fail "no command: $(cat merge_hint)"
expect_exit 3 "${hinted[@]}" --merge
expect_contains stderr 'those of shards 2/3, 3/3'
sed -n 's/^  rubsweep //p' stderr >hints
[[ $(wc -l <hints) == 2 ]] || fail "not two commands: $(cat hints)"
while IFS= read -r hint; do eval "\"\$rubsweep\" $hint --quiet" </dev/null || fail "$hint"; done <hints
eval "\"\$rubsweep\" $(sed 's/^rubsweep //' merge_hint) --quiet"
expect_same 'a b/map.csv' whole/map.csv

# How far a map is.
expect_exit 0 --status part
expect_contains stdout 'part: 24 of 96 cells are finished (25 %), nobody is at work'
expect_matches stdout '^  map.shard-2-of-4 +24  nobody is at work$'
expect_matches stdout '^  map.shard-3-of-4 +-  not begun$'
expect_exit 0 --status whole
expect_contains stdout 'whole: the map is there'
mkdir -p nothing
expect_exit 0 --status nothing
expect_contains stdout 'nothing: no map was begun here'
expect_exit 3 --status no_such_directory
expect_exit 1 --status part --merge

# The same with the map: once where nobody sits at a terminal.
expect_exit 0 --watch part
expect_matches stdout '^ +0\.2 [ .1-9*oqr?]{12}$'
expect_contains stdout 'part: 24 of 96 cells are finished (25 %), nobody is at work'
expect_matches stdout '^  map.shard-2-of-4 +24  nobody is at work$'
expect_exit 0 --watch whole
expect_contains stdout 'whole: the map is there'
expect_contains stdout '  . non_contact'
expect_exit 3 --watch no_such_directory
expect_exit 1 --watch part --fresh
# The same part again has nothing left to do; another division goes on from there.
expect_exit 0 "${quick[@]}" --output part --shard 2/4
expect_contains stderr '24 of 24 cells were finished before'
expect_exit 0 "${quick[@]}" --output part --shard 2/2
expect_contains stderr '24 of 48 cells were finished before'
expect_exit 0 "${quick[@]}" --output part
expect_contains stderr '48 of 96 cells were finished before'
expect_same part/map.csv whole/map.csv
expect_files part config.yaml map.csv

# Killed while the journals were removed after a merge: the map is there, and the rest of them goes.
expect_exit 0 "${quick[@]}" --output merged --shard 1/2
expect_exit 0 "${quick[@]}" --output merged --shard 2/2
cp merged/map.shard-2-of-2.journal kept.journal
expect_exit 0 "${quick[@]}" --output merged --merge
cp kept.journal merged/map.shard-2-of-2.journal
expect_exit 0 "${quick[@]}" --output merged --merge
expect_matches stdout '^ +[0-9]+ +[0-9.]+ %  non_contact$'
expect_same merged/map.csv whole/map.csv
expect_files merged config.yaml map.csv

# Parts of another configuration make room for --fresh, whichever of them comes first or at once; those of this one stay.
for i in 1 2 3 4; do expect_exit 0 "${quick[@]}" --output changed --shard $i/4; done
for i in 1 2 3 4; do
  "$rubsweep" "${quick[@]}" --set rotor.mass_kg=0.9 --output changed --shard $i/4 --fresh --threads 1 --quiet 2>stderr_$i &
  part[i]=$!
done
for i in 1 2 3 4; do wait "${part[i]}" || fail "part $i ended with $?: $(cat stderr_$i)"; done
expect_exit 0 "${quick[@]}" --set rotor.mass_kg=0.9 --output changed --merge
expect_exit 0 "${quick[@]}" --set rotor.mass_kg=0.9 --output changed_whole
expect_same changed/map.csv changed_whole/map.csv
# And so does a finished map.
expect_exit 2 "${quick[@]}" --output changed --shard 1/4
expect_contains stderr 'changed/map.csv: is a finished map of another configuration'
expect_exit 0 "${quick[@]}" --output changed --shard 1/4 --fresh
expect_missing changed/map.csv

# Parts of different studies do not mix, and --fresh forgets one's own part only.
expect_exit 0 "${quick[@]}" --output mixed --shard 1/2
expect_exit 2 "${quick[@]}" --output mixed --shard 2/2 --set rotor.mass_kg=0.9
expect_contains stderr 'mixed/map.shard-1-of-2.journal: holds finished cells of another configuration'
expect_contains stderr 'rotor.mass_kg: 0.8 there, 0.9 here'
expect_exit 0 "${quick[@]}" --output mixed --shard 2/2
expect_exit 0 "${quick[@]}" --output mixed --shard 2/2 --fresh
expect_empty stderr
expect_exit 0 "${quick[@]}" --output mixed --merge
expect_same mixed/map.csv whole/map.csv
