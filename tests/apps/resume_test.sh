#!/usr/bin/env bash
# However a sweep ends before its map is whole, the same command computes the rest, and the map is the one that an
# undisturbed run writes.
source "$(dirname "$0")/support.sh"
set -m
trap 'kill -KILL %% 2>/dev/null || true; rm -rf "$work"' EXIT

quick+=(--set sweep.speed_hz.count=200 --set solver.method=adaptive --set response.floquet_proof=off)
cells=1600
expect_exit 0 "${quick[@]}" --output whole

# resumed DIRECTORY [ARGUMENT]...: the same command again finishes the map.
resumed() {
  expect_exit 0 "${quick[@]}" --output "$@"
  expect_same "$1/map.csv" whole/map.csv
  expect_files "$1" config.yaml map.csv
}

# kill_after DIRECTORY CELLS SIGNAL [ARGUMENT]...: starts a sweep, kills it when CELLS cells are finished.
kill_after() {
  "$rubsweep" "${quick[@]}" --output "$1" "${@:4}" >stdout 2>stderr </dev/null &
  local running=$! code=0
  until [[ -e $1/map.partial.csv ]] && (($(rows "$1/map.partial.csv" | wc -l) >= $2)); do
    kill -0 "$running" 2>/dev/null || break
    sleep 0.002
  done
  kill -s "$3" "$running" 2>/dev/null || true
  wait "$running" 2>/dev/null || code=$?
  # A machine in a hurry may have been done before.
  [[ $code == 0 || $code == $((128 + $(kill -l "$3"))) ]] || fail "exit code $code after $3"
}

# Killed again and again, by every kind of signal, with any number of threads.
kill_after killed 1 KILL --threads 2
expect_matches killed/map.journal ' rubsweep journal 1$'
[[ -e killed/map.csv ]] && fail 'a map that is not whole'
kill_after killed 30 KILL --threads 1
kill_after killed 60 TERM --threads 2
kill_after killed 100 INT --threads 2
# The journal counts: map.partial.csv is behind it by what a kill came between, until the next run writes it anew.
finished=$(grep -c ',ok,kick,' killed/map.journal)
((finished >= 100)) || fail 'finished cells were lost'
resumed killed --threads 1
expect_contains stderr "rubsweep: $finished of $cells cells were finished before"

# Torn and damaged: what is left of a journal counts, whatever was cut.
kill_after torn 30 KILL --threads 1
cp -r torn kept
for bytes in 1 17 400 5000; do
  rm -rf torn && cp -r kept torn
  truncate -s -$bytes torn/map.journal
  resumed torn
done
rm -rf torn && cp -r kept torn
# One letter of the first record.
line=$(grep -n ' records$' torn/map.journal | cut -d: -f1)
sed -i "$((line + 1))s/,ok,kick,/,OK,kick,/" torn/map.journal
resumed torn
expect_contains stderr 'torn/map.journal: 1 damaged records; their cells are computed again'
rm -rf torn && cp -r kept torn
echo nonsense >torn/map.journal
expect_exit 3 "${quick[@]}" --output torn
expect_contains stderr 'torn/map.journal:1: not a journal of this program, or a damaged one'
expect_contains stderr '--fresh to forget it'
[[ $(<torn/map.journal) == nonsense ]] || fail 'the journal did not stay'
resumed torn --fresh

# A damaged header costs nothing where the rest of it says enough: here its first line and one of the study.
rm -rf torn && cp -r kept torn
finished=$(grep -c ',ok,kick,' torn/map.journal)
sed -i -e '1s/rubsweep/Rubsweep/' -e '6s/: */&x/' torn/map.journal
resumed torn
expect_contains stderr 'torn/map.journal: 2 damaged lines before its records, which are used all the same'
expect_contains stderr "$finished of $cells cells were finished before"

# A full disk, seen as a limit on the size of a file.
for kilobytes in 8 40 80; do
  (
    ulimit -f $kilobytes
    expect_exit 3 "${quick[@]}" --output limited --threads 2
  )
  expect_contains stderr 'limited/map.journal: File too large'
done
resumed limited
# The same with a disk, where mounting is allowed.
mkdir disk
if mount -t tmpfs -o size=128k none disk 2>/dev/null; then
  trap 'kill -KILL %% 2>/dev/null || true; umount disk; rm -rf "$work"' EXIT
  expect_exit 3 "${quick[@]}" --output disk/full --threads 2
  expect_contains stderr 'No space left on device'
  expect_missing disk/full/map.csv
  finished=$(rows disk/full/map.partial.csv | wc -l)
  ((finished > 0)) || fail 'nothing was finished before the disk was full'
  mount -o remount,size=2m disk
  resumed disk/full
  expect_contains stderr "of $cells cells were finished before"
else
  echo 'tmpfs: not tested, mounting is not allowed'
fi

# Nothing of an interrupted sweep passes into another one.
kill_after other 2 KILL
changed=(--set rotor.mass_kg=0.9 --set solver.relative_tolerance=1e-7)
expect_exit 0 "${quick[@]}" --output elsewhere "${changed[@]}"
digest_of() { sed -n 's/^# digest //p' "$1/map.csv"; }
there=$(digest_of whole) here=$(digest_of elsewhere)
expect_exit 2 "${quick[@]}" --output other "${changed[@]}"
expect_empty stdout
cat >expected <<TEXT
other/map.journal: holds finished cells of another configuration (digest $there, this one has $here):
  rotor.mass_kg: 0.8 there, 0.9 here
  solver.relative_tolerance: 1e-08 there, 1e-07 here
allowed: the same again, another --output, or --fresh to forget them
TEXT
expect_same stderr expected
expect_contains other/config.yaml 'mass_kg: 0.8'
cp -r other moved
resumed other
# The path is no part of it, nor are the threads.
resumed moved --threads 2 --quiet
kill_after fresh 3 KILL
expect_exit 0 "${quick[@]}" --output fresh "${changed[@]}" --fresh
expect_same fresh/map.csv elsewhere/map.csv
expect_files fresh config.yaml map.csv

# Another build of the program may differ in the last bit.
kill_after build 3 KILL
digest=$(sed -n '3s/^[0-9a-f]* //p' build/map.journal)
sed "s/$digest/$(printf '0%.0s' {1..40})/" "$rubsweep" >other_build
chmod +x other_build
code=0
./other_build "${quick[@]}" --output build >stdout 2>stderr || code=$?
[[ $code == 2 ]] || fail "exit code $code from another build"
expect_contains stderr "build/map.journal: holds finished cells of another build of the program (digest $digest, this one has 0000"
resumed build
