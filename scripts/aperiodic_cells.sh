#!/usr/bin/env bash
# aperiodic_cells.sh MAP.csv...: the cells of the maps that are neither periodic nor without contact, as CSV on stdout:
# quasi-periodic (ovals with their comb spacing are counted in results/README.md, not listed), chaotic and unsettled
# ones, with the exponent that decided. `map` is the name of the directory.
set -euo pipefail

echo map,speed_hz,whirl_ratio,class,lyapunov_per_revolution,status
for map in "$@"; do
  [[ $map == /* ]] || map=./$map # a name with = would be an assignment to awk
  awk -v name="$(basename "$(dirname "$map")")" '
    BEGIN { FS = "," }
    /^#/ { next }
    !header { header = 1; for (i = 1; i <= NF; i++) at[$i] = i; next }
    $at["comb_spacing"] == "" && $at["class"] ~ /^(quasi_periodic|chaotic|unsettled)$/ {
      exponent = $at["lyapunov_per_revolution"]
      printf "%s,%g,%.3f,%s,%s,%s\n", name, $at["speed_hz"], $at["whirl_ratio"], $at["class"], \
        exponent == "" ? "" : sprintf("%.2g", exponent), $at["status"]
    }' "$map"
done
