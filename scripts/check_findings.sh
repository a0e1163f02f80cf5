#!/usr/bin/env bash
# check_findings.sh [--programs DIR] [--maps DIR] [--expected FILE]: what Ishibashi & Kawai report of each contact
# configuration, measured on our maps. Prints a table: finding, measure, whether it holds by the bound set here. Maps are
# taken from DIR/CONFIG_STEM/map.csv (results/ by default) and computed first where they are missing. A finding that does
# not hold is a result, not an error; with --expected the exit code is 1 when the outcome of any finding differs from
# that in FILE, a table as printed here (results/findings.txt). Measures may differ: cells on the edge of a domain do.
set -euo pipefail
export LC_ALL=C.UTF-8
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")
programs=$top/build/release/apps maps=$top/results expected=
while (($#)); do
  case $1 in
    --programs) programs=$2 ;;
    --maps) maps=$2 ;;
    --expected) expected=$2 ;;
    *) echo 'check_findings.sh: usage: check_findings.sh [--programs DIR] [--maps DIR] [--expected FILE]' >&2; exit 2 ;;
  esac
  shift 2
done
maps=$(realpath -ms -- "$maps") # a name with = would be an assignment to awk
# Of all configurations measured here; gap_share is what the offset leaves of the clearance.
natural_frequency_hz=30 clearance_m=1e-3 kick_s=0.005 gap_share=0.75
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

map_of() { printf '%s/%s/map.csv' "$maps" "$1"; }

# measure CONFIG_STEM [OTHER]: sets m[name] to every measure of that map, see findings.awk; OTHER is the map compared.
declare -A m
measure() {
  local map name value
  map=$(map_of "$1")
  # 4: done, but some cells failed.
  [[ -e $map ]] || "$programs/rubsweep" "$top/configs/$1.yaml" --output "$(dirname "$map")" --quiet || (($? == 4))
  m=()
  while read -r name value; do m[$name]=$value; done \
    < <(awk -v natural_frequency_hz="$natural_frequency_hz" -v clearance_m="$clearance_m" -v gap_share="$gap_share" \
      -v other="${2:+$(map_of "$2")}" -f "$here/findings.awk" "$map")
}

# row FINDING MEASURE AWK_CONDITION; a measure that the map does not show makes the condition false, not an error.
row() {
  local holds=no
  if [[ $3 != *none* ]] && awk "BEGIN { exit !($3) }"; then holds=yes; fi
  printf '%-54s | %-68s | %s\n' "$1" "$2" "$holds"
}

trace() { "$programs/rubtrace" "$top/configs/$1.yaml" --output "$work/trace" --quiet "${@:2}"; }

# sample COLUMN CONFIG_STEM CONDITION: twelve cells (lines "SPEED_HZ WHIRL_RATIO") evenly spread over the list of all whose
# COLUMN is not empty and makes the awk CONDITION on `value` true.
sample() {
  awk -v columns="$1 speed_hz whirl_ratio" -f "$here/csv_columns.awk" "$(map_of "$2")" |
    awk "NF == 3 { value = \$1; if ($3) cell[n++] = \$2 \" \" \$3 }
      END { for (i = 0; i < 12 && i < n; i++) print cell[int((i + 0.5) * n / 12)] }"
}

# one_sided_cells: sets even (sampled cells of even order between unequal casings) and one_sided (those that touch one
# stop only in the last 64 revolutions).
one_sided_cells() {
  local speed_hz whirl_ratio
  while read -r speed_hz whirl_ratio; do
    trace both_sides_unequal --speed-hz "$speed_hz" --whirl-ratio "$whirl_ratio" --last-revolutions 64
    awk -v columns='gap_0_m gap_1_m' -f "$here/csv_columns.awk" "$work/trace/trajectory.csv" |
      awk '{ if ($1 < 0) upper = 1; if ($2 < 0) lower = 1 } END { print upper + lower }'
  done < <(sample order both_sides_unequal 'value > 1 && value % 2 == 0') >"$work/stops_touched"
  read -r even one_sided < <(awk '$1 == 1 { one++ } END { print NR, one + 0 }' "$work/stops_touched")
}

# casing_in_gaps: sets gap_cells and, over all times that the rotor comes near the wall in the middle cells of the gaps,
# approaches, beyond (casing more than a clearance away), away (moving away), farthest (its displacement, clearances).
casing_in_gaps() {
  local n speed_hz whirl_ratio
  gap_cells=0
  : >"$work/approaches"
  while read -r n speed_hz whirl_ratio; do
    gap_cells=$((gap_cells + 1))
    trace figure06_one_side --speed-hz "$speed_hz" --whirl-ratio "$whirl_ratio" --set response.max_revolutions=128
    awk -v columns='t_s y_m casing_0_y_m gap_0_m' -f "$here/csv_columns.awk" "$work/trace/trajectory.csv" |
      awk -v clearance_m="$clearance_m" -v kick_s="$kick_s" -f "$here/gap_approaches.awk" >>"$work/approaches"
  done < <(awk -f "$here/gap_cells.awk" "$(map_of figure06_one_side)")
  read -r approaches beyond away farthest < <(awk '
    { if ($2 > 1) beyond++; if ($3 > 0) away++; if (NR == 1 || $2 > farthest) farthest = $2 }
    END { printf "%d %d %d %.2f\n", NR, beyond, away, farthest }' "$work/approaches")
}

# oval_shapes: runs twelve cells of ovals, evenly spread over the list of all, and sets ovals (how many), ellipses (those
# whose whirl is an ellipse that hardly turns: axes below 0.9 : 1, less than 0.1 turns per revolution, two lines with
# 80 % of the energy off 1X), axes_low and axes_high (short axis / long axis of these).
oval_shapes() {
  local speed_hz whirl_ratio
  while read -r speed_hz whirl_ratio; do
    trace figure11_annulus --speed-hz "$speed_hz" --whirl-ratio "$whirl_ratio" --last-revolutions 1
    awk -f "$here/oval_shape.awk" "$work/trace/spectrum.csv"
  done < <(sample comb_spacing figure11_annulus 1) >"$work/ovals"
  read -r ovals ellipses axes_low axes_high < <(awk '
    $2 < 0.1 && $2 > -0.1 && $1 < 0.9 && $3 > 0.8 {
      ellipses++
      if (low == "" || $1 < low) low = $1
      if ($1 > high) high = $1
    }
    END { print NR, ellipses + 0, low == "" ? "none" : low, high == "" ? "none" : high }' "$work/ovals")
}

print_table() {
  local n low lean least='' odd
  printf '%-54s | %-68s | %s\n' finding measured holds
  measure figure06_one_side
  for n in 2 3 4 5; do
    low=${m[o${n}_lowest]:-none} lean=${m[o${n}_lean]:-none}
    row "1: one side: 1/$n starts above $n natural frequencies" "lowest at $low" "$low > $n && $low < $n + 1.5"
    row "1: one side: 1/$n moves up in speed with unbalance" "mean speed $lean higher above whirl ratio 0.6" "$lean > 0"
    least+="${least:+, }${m[o${n}_least_ratio]:-none}"
  done
  row '1: one side: larger n from smaller unbalance' "least whirl ratio $least (n = 2 to 5)" \
    "${m[o3_least_ratio]:-none} <= ${m[o2_least_ratio]:-none} && ${m[o5_least_ratio]:-none} < ${m[o2_least_ratio]:-none}"
  row '1: one side: gaps between the domains' "${m[gap_2]}, ${m[gap_3]}, ${m[gap_4]} quiet cells after 1/2, 1/3, 1/4" \
    "${m[gap_2]} > 0 && ${m[gap_3]} > 0 && ${m[gap_4]} > 0"
  casing_in_gaps
  row '1: one side: casing a clearance away in the gaps' \
    "$beyond of $approaches approaches in $gap_cells cells, farthest $farthest clearances" "$beyond > 0.5 * $approaches"
  row '1: one side: casing moving away in the gaps' "$away of $approaches approaches" "$away > 0.9 * $approaches"

  measure figure09_both_sides
  row '2: both sides: synchronous over a wide speed range' "up to ${m[synchronous_top]} natural frequencies" \
    "${m[synchronous_top]} > 3"
  row '2: both sides: subharmonic at small unbalance only' \
    "${m[subharmonic_upper_percent]} % of the subharmonic cells above whirl ratio 0.5" "${m[subharmonic_upper_percent]} < 10"
  odd=${m[even_percent]}
  row '2: both sides: only odd orders with equal casings' "$odd % of the subharmonic cells are even" "$odd < 10"
  measure both_sides_unequal
  row '2: both sides: even orders with unequal casings' "${m[even_percent]} % of the subharmonic cells are even" \
    "${m[even_percent]} > 10 && ${m[even_percent]} > 2 * $odd"
  one_sided_cells
  row '2: both sides: unequal casings, contact on one side' "$one_sided of $even sampled cells of even order" "$one_sided > 0"

  measure figure11_annulus
  local circle=${m[circle_top]} small=${m[small_circle_cells]}
  row '3: annulus: synchronous circle at low speed' "up to $circle natural frequencies" "$circle > 2"
  row '3: annulus: oval whirl at high speed' "${m[oval_cells]} cells, from ${m[oval_lowest]:-none} natural frequencies" \
    "${m[oval_cells]} > 0 && ${m[oval_lowest]:-none} > 2"
  row '3: annulus: the oval from smaller unbalance' \
    "from whirl ratio ${m[oval_least_ratio]:-none}, the circle from ${m[circle_least_ratio]:-none}" \
    "${m[oval_least_ratio]:-none} < ${m[circle_least_ratio]:-none}"
  oval_shapes
  row '3: annulus: the whirl is an oval' \
    "$ellipses of $ovals sampled cells are ellipses with axes of $axes_low to $axes_high : 1" "$ellipses > 0.5 * $ovals"
  row '3: annulus: the oval hits several times per whirl' \
    "median ${m[oval_hits]:-none} hits; more than 1.5 in ${m[oval_repeated_percent]:-none} % of the cells" \
    "${m[oval_repeated_percent]:-none} > 50"

  measure figure12_annulus_offset figure11_annulus
  row '4: offset: circle to higher speed, same whirl ratio' \
    "up to ${m[circle_top]} (centred: $circle); higher in ${m[wide_rows]} of ${m[circle_rows]} rows" \
    "${m[wide_rows]} > 0.5 * ${m[circle_rows]}"
  row '4: offset: circle to higher speed, same unbalance' \
    "higher in ${m[wide_rows_alike]} of ${m[circle_rows_alike]} rows" "${m[wide_rows_alike]} > 0.5 * ${m[circle_rows_alike]}"
  row '4: offset: subharmonics slightly above n' \
    "1/2 from ${m[s2_lowest]:-none}, 1/3 from ${m[s3_lowest]:-none} natural frequencies" \
    "${m[s2_lowest]:-none} > 2 && ${m[s2_lowest]:-none} < 2.5 && ${m[s3_lowest]:-none} > 3 && ${m[s3_lowest]:-none} < 3.5"
  row '4: offset: another kind of synchronous circle' \
    "${m[small_circle_cells]} circles smaller than the clearance (centred: $small)" "${m[small_circle_cells]} > 0 && $small == 0"
}

print_table | tee "$work/table"
[[ -n $expected ]] || exit 0
# The last column alone decides.
outcomes() { awk -F ' *[|] *' '{ print $1 " | " $3 }' "$1"; }
diff <(outcomes "$expected") <(outcomes "$work/table") >"$work/difference" ||
  { printf 'check_findings.sh: other outcomes than in %s:\n' "$expected"; cat "$work/difference"; exit 1; } >&2
