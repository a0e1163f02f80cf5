#!/usr/bin/env bash
# The batch scripts of docs/guide/clusters.md, run as they stand there with what Slurm would set. The fourth argument is
# rubsweep-mpi, or missing.
source "$(dirname "$0")/support.sh"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
PATH=$(dirname "$rubsweep"):$PATH
expect_exit 0 "${quick[@]}" --set output.directory=map --print-config
cp stdout sweep.yaml
expect_exit 0 sweep.yaml --output whole

guide=$top/docs/guide/clusters.md
# The indented blocks that begin with #!/bin/bash, one file each.
awk '/^    #!\/bin\/bash/ { file = "job_" ++jobs } !/^    / { file = "" } file { print substr($0, 5) > file }' "$guide"
[[ $(echo job_*) == 'job_1 job_2' ]] || fail 'the page does not have two batch scripts'
export SLURM_CPUS_PER_TASK=2
[[ $(<job_1) =~ --array=1-([0-9]+) ]] || fail 'the first script is no array'
for ((i = 1; i <= BASH_REMATCH[1]; ++i)); do
  SLURM_ARRAY_TASK_ID=$i bash -e job_1 >stdout 2>stderr || fail "shard $i: exit code $?"
done
grep -oE '^    \$ rubsweep sweep.yaml --merge' "$guide" | head -1 | cut -c7- >merge
[[ -s merge ]] || fail 'the page does not merge'
bash -e merge >stdout 2>stderr || fail "merge: exit code $?"
expect_same map/map.csv whole/map.csv

if (($# > 3)); then
  rm -r map
  bash -e job_2 >stdout 2>stderr || fail "mpirun: exit code $?"
  expect_same map/map.csv whole/map.csv
fi
