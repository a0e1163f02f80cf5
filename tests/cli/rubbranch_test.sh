#!/usr/bin/env bash
# rubbranch: what it writes, what it prints and how it ends.
source "$(dirname "$0")/support.sh"
figure06=$top/configs/figure06_one_side.yaml

# Command line.
expect_help cell along from to switch points
expect_usage_error 'a configuration file is needed'
expect_usage_error 'a cell to start from is needed' "$minimal"
expect_usage_error '--cell 75: allowed: SPEED_HZ,UNBALANCE' "$minimal" --cell 75
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

# The half orbit of the reference machine: closed between two folds, the same from two cells.
expect_exit 0 "$figure06" --cell 75,0.4 --output first
expect_empty stderr
expect_files first branch.csv config.yaml events.csv
expect_matches stdout '^branch 0  order 2, speed_hz .* ends closed and closed$'
[[ $(count_rows first/events.csv "kind == 'fold'") == 2 ]] || fail 'not two folds'
[[ $(count_rows first/branch.csv "order != 2 or feasible != 1") == 0 ]] || fail 'an orbit of another order'
[[ $(count_rows first/branch.csv "(floquet_modulus < 1) != (stable == 1)") == 0 ]] || fail 'stability and multipliers differ'
expect_exit 0 "$figure06" --cell 84,0.4 --output second
folds() { cells "$1/events.csv" kind parameter | awk -F, '$1 == "fold" { printf "%.9g\n", $2 }' | sort; }
expect_same <(folds first) <(folds second)

# Along the unbalance, with the orbit of twice the period, and along any number of the configuration.
expect_exit 0 "$figure06" --cell 75,0.3 --along whirl_ratio --switch --output doubled
expect_matches stdout '^branch 1  order 4, whirl_ratio .* ends period_halving and left_range$'
expect_exit 0 "$figure06" --cell 75,0.4 --along stops.0.casing.mass_kg --from 0.04 --to 0.06 --output casing
expect_matches stdout '^branch 0  order 2, stops.0.casing.mass_kg 0.04 to 0.06, .* ends left_range and left_range$'

# What it is along does not change an orbit: the same one by the speed of another configuration.
expect_exit 0 "$figure06" --cell 75,0.4 --along kick.force_n --from 190 --to 210 --output kick
[[ $(cells kick/branch.csv floquet_modulus | awk '{ printf "%.6f\n", $1 }' | sort -u | wc -l) == 1 ]] ||
  fail 'the kick changes an orbit that is there without it'
