#!/usr/bin/env bash
# check_findings.sh: what Ishibashi & Kawai report of each contact configuration, measured on our maps (computed first
# where results/ does not hold them). Prints a table: finding, measure, holds or not; exits 1 when one does not hold.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$top/build/release/apps/rubsweep
natural_frequency_hz=30
failures=0

# measure CONFIG_STEM: sets m[name] for every measure of that map.
declare -A m
measure() {
  local map=$top/results/$1/map.csv name value
  [[ -e $map ]] || "$program" "$top/configs/$1.yaml" --output "$(dirname "$map")" --quiet
  m=()
  while read -r name value; do m[$name]=$value; done \
    < <(awk -v natural_frequency_hz="$natural_frequency_hz" -f "$top/scripts/findings.awk" "$map")
}

# row FINDING MEASURE AWK_CONDITION
row() {
  local holds=no
  if awk "BEGIN { exit !($3) }"; then holds=yes; else failures=$((failures + 1)); fi
  printf '%-58s | %-48s | %s\n' "$1" "$2" "$holds"
}

printf '%-58s | %-48s | %s\n' finding measured holds
measure figure06_one_side
for n in 2 3 4 5; do
  low=${m[o${n}_lowest]} lean=${m[o${n}_lean]}
  row "6: 1/$n starts above $n natural frequencies" "lowest at $low" "$low > $n && $low < $n + 1.5"
  row "6: 1/$n moves to higher speed with unbalance" "mean speed $lean higher above ratio 0.6" "$lean > 0"
done
row '6: larger n from smaller unbalance' "least ratio ${m[o2_least_ratio]}, ${m[o3_least_ratio]}, ${m[o4_least_ratio]}, ${m[o5_least_ratio]} (n = 2..5)" \
  "${m[o3_least_ratio]} <= ${m[o2_least_ratio]} && ${m[o5_least_ratio]} < ${m[o2_least_ratio]}"
row '6: gaps between the domains' "${m[gap_2]}, ${m[gap_3]}, ${m[gap_4]} quiet cells after 1/2, 1/3, 1/4" \
  "${m[gap_2]} > 0 && ${m[gap_3]} > 0 && ${m[gap_4]} > 0"
measure figure09_both_sides
row '9: synchronous over a wide speed range' "up to ${m[synchronous_top]} natural frequencies" "${m[synchronous_top]} > 3"
row '9: only odd orders with equal casings' "${m[even_percent]} % of the subharmonic cells are even" "${m[even_percent]} < 10"
measure figure11_annulus
circle=${m[circle_top]}
row '11: synchronous circle at low speed' "up to $circle natural frequencies" "$circle > 2"
measure figure12_annulus_offset
row '12: the circle reaches higher speed with offset' "up to ${m[circle_top]} (centred: $circle)" "${m[circle_top]} > $circle"
row '12: subharmonics slightly above n natural frequencies' "1/2 from ${m[o2_lowest]:-99}" "${m[o2_lowest]:-99} > 2 && ${m[o2_lowest]:-99} < 2.5"
((failures == 0))
