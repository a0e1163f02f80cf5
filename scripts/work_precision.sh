#!/usr/bin/env bash
# work_precision.sh TABLE.csv OUTPUT_BASENAME HEADING: draws what rubbench wrote as OUTPUT_BASENAME.png, error against
# processor time per revolution, a row of panels for every cell. Variants that failed are left out.
set -euo pipefail
export LC_ALL=C.UTF-8
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

(($# == 3)) || { echo 'work_precision.sh: usage: work_precision.sh TABLE.csv OUTPUT_BASENAME HEADING' >&2; exit 1; }
# Absolute names: to gnuplot and awk others may be commands or assignments.
table=$(realpath -ms -- "$1") output=$(realpath -ms -- "$2") heading=$3
[[ -r $table ]] || { echo "work_precision.sh: cannot read $table" >&2; exit 3; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Blocks by cell, contact, stepper and method. Closed forms alone are a single point, drawn in both columns.
awk -F, -v data="$work/data" '
  /^#/ { next }
  $1 == "cell" { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  $(at["microseconds_per_revolution"]) == "" || $(at["state_error"]) == "" { next }
  {
    cell = $(at["cell"])
    if (!(cell in number)) { number[cell] = ++cells; title[cells] = cell }
    time = $(at["microseconds_per_revolution"]) + 0
    error = $(at["state_error"]) + 0
    if (error <= 0 || time <= 0) next
    stepper = $(at["stepper"])
    if (stepper == "") stepper = "exact"
    if (!least_time || time < least_time) least_time = time
    if (time > most_time) most_time = time
    if (!least_error || error < least_error) least_error = error
    if (error > most_error) most_error = error
    point(number[cell] "_" $(at["contact"]) "_" stepper "_" $(at["method"]), time, error)
    if (stepper == "exact") point(number[cell] "_smoothed_exact_exact", time, error)
  }
  # As gnuplot reads it between single quotes, where it knows one escape.
  function quoted(text) { gsub(/[[:cntrl:]]/, "?", text); gsub(/\047/, "&&", text); return "\047" text "\047" }
  function point(name, time, error) {
    if (!(name in block)) names[++count] = name
    block[name] = block[name] time " " error "\n"
  }
  END {
    if (!cells) { print "work_precision.sh: no run to draw" > "/dev/stderr"; exit 3 }
    known = " "
    for (i = 1; i <= count; ++i) {
      printf "# %s\n%s\n\n", names[i], block[names[i]] > data
      known = known names[i] " "
    }
    settings = data ".gp"
    printf "array cell_title[%d]\n", cells > settings
    for (i = 1; i <= cells; ++i) printf "cell_title[%d] = %s\n", i, quoted(title[i]) > settings
    printf "low_time = %g\nhigh_time = %g\n", least_time / 2, most_time * 2 > settings
    printf "low_error = %g\nhigh_error = %g\n", least_error / 3, most_error * 3 > settings
    printf "known = %s\nhas(name) = strstrt(known, \" \" . name . \" \") > 0\n", quoted(known) > settings
    print cells > (data ".cells")
  }' "$table"

mkdir -p "$(dirname "$output")"
gnuplot -c "$here/work_precision.gp" "$work/data" "$output.png" "$heading" "$(<"$work/data.cells")"
