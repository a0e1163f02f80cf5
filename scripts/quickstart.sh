#!/usr/bin/env bash
# From a fresh clone to the first map: builds, computes figure 6 (one-side stop) and draws it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/bootstrap.sh
cmake --preset release
cmake --build --preset release --target rubsweep
# 4: done, but some cells failed; the figure shows which.
build/release/apps/rubsweep configs/reference/figure06_one_side.yaml --output results/reference/figure06_one_side --fresh || (($? == 4))
scripts/figure06.sh

printf 'Map:     %s\n' results/reference/figure06_one_side/map.csv
printf 'Figures: %s\n' results/figures/figure06.png results/figures/figure06.svg
printf 'Done in %d min %02d s.\n' $((SECONDS / 60)) $((SECONDS % 60))
