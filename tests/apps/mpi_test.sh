#!/usr/bin/env bash
# rubsweep-mpi: several ranks write the map that one process writes, also after some of them were killed.
source "$(dirname "$0")/support.sh"
set -m
trap 'kill -KILL %% 2>/dev/null || true; rm -rf "$work"' EXIT
program=$4 mpirun=$5
# Fewer processors than ranks, and containers where everybody is root, are allowed here.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_btl_base_warn_component_unused=0 OMPI_MCA_btl=self,vader

# expect_mpi CODE RANKS [ARGUMENT]...: with `threads` for each rank, 1 where that is not set.
expect_mpi() {
  local expected=$1 ranks=$2 code=0
  shift 2
  "$mpirun" -n "$ranks" --oversubscribe "$program" "$@" --threads "${threads:-1}" >stdout 2>stderr </dev/null || code=$?
  [[ $code == "$expected" ]] || fail "mpirun -n $ranks rubsweep-mpi $*: exit code $code, expected $expected"
}

expect_exit 0 "${quick[@]}" --output whole
for ranks in 1 2 3; do
  expect_mpi 0 $ranks "${quick[@]}" --output "ranks_$ranks"
  expect_matches stdout '^ +96  100\.0 %  non_contact$'
  expect_same "ranks_$ranks/map.csv" whole/map.csv
  expect_files "ranks_$ranks" config.yaml map.csv
done

# One line of JSON of all ranks, the only one with --quiet.
expect_mpi 0 3 "${quick[@]}" --output summed --quiet --summary json
[[ $(wc -l <stdout) == 1 ]] || fail "not one line: $(<stdout)"
expect_contains stdout '"program":"rubsweep-mpi"'
expect_contains stdout '"non_contact":96'

# A refined map, of which nobody knows beforehand what it wants; rounds end where a rank has nothing to do.
refined=("$minimal" --set 'sweep={speed_hz: {from: 60, to: 100, count: 21}, whirl_ratio: {from: 0.1, to: 0.9, count: 17}, refine: {levels: 3, probes: 1}}')
expect_exit 0 "${refined[@]}" --output refined
grep -E '^(refined|boundaries): ' stderr >refined_description
for ranks in 1 3; do
  expect_mpi 0 $ranks "${refined[@]}" --output "refined_$ranks"
  expect_same "refined_$ranks/map.csv" refined/map.csv
  expect_same <(grep -E '^(refined|boundaries): ' stderr) refined_description
done

# The first rank writes page and picture, of a map that is there as well.
expect_exit 0 "${quick[@]}" --output whole --report --quiet
expect_mpi 0 2 "${quick[@]}" --output reported --report
expect_matches stdout '^report: .*/reported/report.html'
expect_same reported/report.html whole/report.html
rm reported/report.html
expect_mpi 0 2 "${quick[@]}" --output reported --report --quiet
expect_same reported/report.html whole/report.html
if command -v gnuplot >/dev/null; then
  expect_exit 0 "${quick[@]}" --output whole --figure whole.svg --quiet
  expect_mpi 0 2 "${quick[@]}" --output drawn --figure drawn.svg
  expect_contains stdout 'figure: drawn.svg'
  expect_same drawn.svg whole.svg
fi

# A map of some seconds, and one rank is killed in the middle, at its first finished cell: the job ends, the finished
# cells stay. On a busy machine the job may be done before this script gets to look: then once more.
slow=("$minimal" --set sweep.speed_hz.count=20 --set solver.method=adaptive --set response.floquet_proof=off)
cells=80
expect_exit 0 "${slow[@]}" --output slow
for ((attempt = 1; ; ++attempt)); do
  rm -rf killed
  "$mpirun" -n 3 --oversubscribe "$program" "${slow[@]}" --output killed --threads 1 >stdout 2>stderr </dev/null &
  running=$!
  until [[ -e killed/map.csv ]] || grep -qs ',ok,kick,' killed/map.rank-2.journal; do
    kill -0 $running 2>/dev/null || break
    sleep 0.01
  done
  ranks=()
  read -ra ranks 2>/dev/null <"/proc/$running/task/$running/children" || true
  if ((${#ranks[@]})) && kill -KILL "${ranks[-1]}" 2>/dev/null && ! wait $running 2>/dev/null; then break; fi
  ((attempt < 10)) || fail 'the job was always done before one of its ranks could be killed'
done
expect_missing killed/map.csv
finished=$(cat killed/map*.journal | grep -c ',ok,kick,')
((finished > 0 && finished < cells)) || fail "$finished cells were finished"
# The rest with another number of ranks, or without MPI; both programs of a build may share the work.
cp -r killed copy
expect_mpi 0 2 "${slow[@]}" --output killed
expect_contains stderr "rubsweep-mpi: $finished of $cells cells were finished before"
expect_same killed/map.csv slow/map.csv
expect_files killed config.yaml map.csv
expect_exit 0 "${slow[@]}" --output copy
expect_contains stderr "rubsweep: $finished of $cells cells were finished before"
expect_same copy/map.csv slow/map.csv

# A finished map: of this configuration nothing is left to do, one of another is refused unless --fresh replaces it.
expect_mpi 0 2 "${quick[@]}" --output ranks_2
expect_contains stderr 'rubsweep-mpi: the map is there, nothing is left to do'
expect_matches stdout '^ +96  100\.0 %  non_contact$'
expect_mpi 2 2 "${quick[@]}" --output ranks_2 --set rotor.mass_kg=0.9
expect_contains stderr 'ranks_2/map.csv: is a finished map of another configuration'
expect_same ranks_2/map.csv whole/map.csv
expect_mpi 0 2 "${quick[@]}" --output ranks_3 --set rotor.mass_kg=0.9 --fresh

# A signal to one rank ends the work of all, whether their cells end soon or not: 143, and the lock is free.
endless=("$minimal" --set 'sweep={speed_hz: {values: [70, 70.1, 70.2, 70.3]}, whirl_ratio: {values: [0.2]}}' --set solver.method=adaptive
  --set solver.stepper=rosenbrock4 --set solver.relative_tolerance=1e-14 --set solver.max_steps_per_revolution=1e9)
for kind in slow endless; do
  declare -n sweep=$kind
  for ((attempt = 1; ; ++attempt)); do
    rm -rf "term_$kind"
    "$mpirun" -n 2 --oversubscribe "$program" "${sweep[@]}" --output "term_$kind" --threads 1 >stdout 2>stderr </dev/null &
    running=$!
    until [[ -e term_$kind/map.csv || -e term_$kind/map.rank-1.journal ]]; do
      kill -0 $running 2>/dev/null || break
      sleep 0.01
    done
    ranks=()
    read -ra ranks 2>/dev/null <"/proc/$running/task/$running/children" || true
    code=0
    ((${#ranks[@]})) && kill -TERM "${ranks[-1]}" 2>/dev/null || true
    wait $running 2>/dev/null || code=$?
    [[ $code == 0 ]] || break
    ((attempt < 10)) || fail 'the job was always done before one of its ranks could be signalled'
  done
  [[ $code == 143 ]] || fail "exit code $code after a signal to one rank"
  expect_missing "term_$kind/map.lock"
  expect_missing "term_$kind/map.csv"
done
expect_mpi 0 2 "${slow[@]}" --output term_slow
expect_same term_slow/map.csv slow/map.csv

# Memory and disk space are said beforehand, and refused where they are too much, as by rubsweep.
long=("${quick[@]}" --set sweep.speed_hz.count=125)
expect_mpi 0 2 "${long[@]}" --output long --progress always
expect_matches stderr $'(^|\r)1000 cells on 2 ranks of 1 threads: up to [0-9.]+ MB of memory each, 1.0 MB of disk *$'
expect_matches stderr $'(^|\r)about 0:0[0-9]:[0-9]{2} by [0-9]+ cells spread over the map *$'
expect_exit 0 "${long[@]}" --output long_alone
expect_same long/map.csv long_alone/map.csv
threads=1024 expect_mpi 2 2 "$minimal" --output large \
  --set 'response={window_revolutions: 4096, samples_per_revolution: 4096, max_revolutions: 10000}'
expect_matches stderr '^24 cells on 2 ranks of 1024 threads: .*, this machine has [0-9]+ MB for each, allowed: fewer ranks'
expect_missing large

# Problems that the first rank finds are said once, and end all of them.
expect_mpi 2 2 "${quick[@]}" --set rotor.mass_kg=-1
[[ $(grep -c 'rotor.mass_kg: -1 is out of range' stderr) == 1 ]] || fail 'not said once'
expect_mpi 3 2 missing.yaml
only_maps='rubsweep-mpi: this program only computes maps; use rubsweep for everything else'
expect_mpi 1 2 "${quick[@]}" --shard 1/2
expect_contains stderr "$only_maps"
expect_mpi 1 2 "$top/configs/rotor_kit.yaml" --export-matrices matrices
expect_contains stderr "$only_maps"
expect_missing matrices
for question in --motion-kinds --keys --schema; do
  code=0
  "$mpirun" -n 2 --oversubscribe "$program" "$question" >stdout 2>stderr </dev/null || code=$?
  [[ $code == 1 ]] || fail "$question: exit code $code"
  expect_contains stderr "$only_maps"
done
expect_mpi 0 2 --help
[[ $(grep -c '^mpirun -n N rubsweep-mpi' stdout) == 1 ]] || fail 'not helped once'
# A process alone answers without a session of MPI, which needs TMPDIR.
TMPDIR=$work/stdout "$program" --help >alone
expect_same alone stdout
TMPDIR=$work/stdout "$program" --version >alone
expect_contains alone 'rubsweep-mpi'
code=0
TMPDIR=$work/stdout "$program" --no-such-option 2>stderr || code=$?
[[ $code == 1 ]] || fail "an unknown option alone: exit code $code"
# A full disk ends all ranks; where mounting is allowed.
mkdir disk
if mount -t tmpfs -o size=36k none disk 2>/dev/null; then
  trap 'kill -KILL %% 2>/dev/null || true; umount disk; rm -rf "$work"' EXIT
  expect_mpi 3 2 "${quick[@]}" --output disk/full
  expect_contains stderr 'No space left on device'
  mount -o remount,size=1m disk
  expect_mpi 0 2 "${quick[@]}" --output disk/full
  expect_contains stderr 'of 96 cells were finished before'
  expect_same disk/full/map.csv whole/map.csv
fi
