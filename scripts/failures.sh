#!/usr/bin/env bash
# failures.sh: what a sweep survives, one after the other on the real program: each command that ends early, its exit code
# and what it says, the same command again, and the comparison with the map of an undisturbed run. Prints a transcript;
# exits with 1 where a map is not byte for byte the same or an exit code is not the expected one.
set -euo pipefail
set -m # background jobs heed SIGINT
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
PATH=$top/build/release/apps:$PATH
command -v rubsweep >/dev/null || { echo 'failures.sh: no rubsweep; scripts/test.sh' >&2; exit 1; }
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
work=$(mktemp -d)
trap 'kill -KILL %% 2>/dev/null || true; umount "$work/disk" 2>/dev/null || true; rm -rf "$work"' EXIT
cd "$work"
broken=0

# A sweep of some seconds: 120 cells by the adaptive solver.
rubsweep "$top/configs/minimal.yaml" --set sweep.speed_hz.count=30 --set solver.method=adaptive --set response.floquet_proof=off \
  --print-config >sweep.yaml
rubsweep sweep.yaml --output whole --quiet

expect_code() { [[ $1 == "$2" ]] || { echo "exit code $1, expected $2"; broken=1; }; }

# show EXPECTED_CODE COMMAND...: runs it in the foreground.
show() {
  local expected=$1 code=0
  shift
  echo "\$ $*"
  eval "$*" >said 2>&1 || code=$?
  grep -v '^ *[0-9]* *[0-9.]* %' said | head -n 6 # without the summary of the map
  echo "exit code $code"
  expect_code "$code" "$expected"
}

# strike EXPECTED_CODE SIGNAL CELLS DIRECTORY COMMAND...: sends it the signal as soon as so many cells are finished.
strike() {
  local expected=$1 signal=$2 cells=$3 directory=$4 code=0 running
  shift 4
  echo "\$ $* &    kill -$signal when $cells cells are finished"
  eval "exec $*" >said 2>&1 &
  running=$!
  until (($(cat "$directory"/*.journal 2>/dev/null | grep -c ',ok,kick,' || true) >= cells)); do
    kill -0 $running 2>/dev/null || break
    sleep 0.01
  done
  kill -s "$signal" $running 2>/dev/null || true
  wait $running 2>/dev/null || code=$?
  head -n 4 said
  echo "exit code $code"
  expect_code "$code" "$expected"
}

# same DIRECTORY: compares its map with that of the undisturbed run.
same() {
  echo "\$ cmp whole/map.csv $1/map.csv"
  if cmp whole/map.csv "$1/map.csv"; then echo 'byte for byte the same'; else broken=1; fi
  echo
}

echo '== Killed'
strike 137 KILL 10 killed 'rubsweep sweep.yaml --output killed'
show 0 'rubsweep sweep.yaml --output killed'
same killed

echo '== Interrupted'
strike 130 INT 10 interrupted 'rubsweep sweep.yaml --output interrupted'
show 0 'rubsweep sweep.yaml --output interrupted'
same interrupted

echo '== A full disk: no file may grow beyond 8 KB'
show 3 '(ulimit -f 8; rubsweep sweep.yaml --output limited)'
show 0 'rubsweep sweep.yaml --output limited'
same limited

mkdir disk
if mount -t tmpfs -o size=48k none disk 2>/dev/null; then
  echo '== A full disk: a file system of 48 KB, then of 2 MB'
  show 3 'rubsweep sweep.yaml --output disk/map'
  mount -o remount,size=2m disk
  show 0 'rubsweep sweep.yaml --output disk/map'
  same disk/map
fi

echo '== A changed configuration, then --fresh'
strike 137 KILL 5 changed 'rubsweep sweep.yaml --output changed'
show 2 'rubsweep sweep.yaml --output changed --set rotor.mass_kg=0.9'
show 0 'rubsweep sweep.yaml --output changed'
same changed
strike 137 KILL 5 fresh 'rubsweep sweep.yaml --output fresh --set rotor.mass_kg=0.9'
show 0 'rubsweep sweep.yaml --output fresh --fresh'
same fresh

echo '== Two at once'
rubsweep sweep.yaml --output busy --quiet &
running=$!
until [[ -e busy/map.journal ]]; do sleep 0.01; done
show 6 'rubsweep sweep.yaml --output busy'
wait $running
same busy

if command -v rubsweep-mpi >/dev/null; then
  echo '== A rank of three killed'
  echo '$ mpirun -n 3 rubsweep-mpi sweep.yaml --output ranks --threads 1 &    kill -KILL a rank that has finished a cell'
  code=0
  mpirun -n 3 --oversubscribe rubsweep-mpi sweep.yaml --output ranks --threads 1 >said 2>&1 &
  running=$!
  until grep -qs ',ok,kick,' ranks/map.rank-2.journal; do
    kill -0 $running 2>/dev/null || break
    sleep 0.01
  done
  read -ra ranks 2>/dev/null <"/proc/$running/task/$running/children" || true
  kill -KILL "${ranks[-1]}" 2>/dev/null || true
  wait $running 2>/dev/null || code=$?
  grep -m 1 'exited on signal' said || true
  echo "exit code $code, $(cat ranks/*.journal | grep -c ',ok,kick,') cells in the journals"
  show 0 'mpirun -n 2 --oversubscribe rubsweep-mpi sweep.yaml --output ranks --threads 1'
  same ranks
fi
exit "$broken"
