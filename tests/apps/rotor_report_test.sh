#!/usr/bin/env bash
# rubtrace --rotor-report: the page and its tables, what is left out of which rotor, and what is refused.
source "$(dirname "$0")/support.sh"
ross=$top/configs/gallery/ross_rotor.yaml

refused() {
  local text=$1
  shift
  expect_usage_error "$text" "$minimal" "$@"
}
refused '--rotor-report excludes --free-response, --run-up, --campbell and --design-check' --rotor-report out --campbell 10:20
refused '--rotor-report excludes' --rotor-report out --design-check
refused '--output: --rotor-report names the directory itself' --rotor-report out --output other
refused '--rotor-report: allowed: the name of a directory' --rotor-report ''
refused '--figure belongs to a trace' --rotor-report out --figure out.png
refused '--whirl-ratio belongs to a trace' --rotor-report out --whirl-ratio 0.3
refused '--revolutions belongs to a trace' --rotor-report out --revolutions 3
refused "--operating-hz: '20:10' is not allowed" --rotor-report out --operating-hz 20:10
refused '--operating-hz and --operating-rpm exclude each other' --rotor-report out --operating-hz 50:60 --operating-rpm 3000:3600
refused '--operating-hz and --operating-rpm belong to --design-check and --rotor-report' --campbell 10:20 --operating-hz 50:60
refused '--operating-hz: 4500 Hz is over 100 times the lowest natural frequency' --rotor-report out --operating-hz 50:4500
refused '--speed-hz: 4500 Hz is over 100 times the lowest natural frequency' --rotor-report out --speed-hz 4500
refused '--threads belongs to --design-check' --rotor-report out --threads 2
expect_exit 1 "$top/configs/gallery/bearing_table.yaml" --rotor-report out --operating-hz 50:200
expect_contains stderr '--operating-hz: the tables of the supports do not reach 200 Hz (12000 rpm)'
expect_missing out
touch file
expect_exit 3 "$minimal" --rotor-report file
expect_contains stderr 'file'
mkdir -p map
echo >map/map.csv
expect_exit 2 "$minimal" --rotor-report map
expect_contains stderr 'map: holds a map'

# expect_page PICTURES MISSING: so many pictures are on the page, so many are left out, and it asks no other host.
expect_page() {
  local page=out/rotor_report.html
  [[ $(grep -o '<img alt="[^"]*" src="data:image/png;base64,' "$page" | wc -l) == "$1" ]] || fail "not $1 pictures"
  [[ $(grep -c 'class="missing"' "$page" || true) == "$2" ]] || fail "not $2 pictures are missing"
  ! sed 's/src="data:[^"]*"//g' "$page" | grep -qE 'https?:|src=|<script|@import|url\(' || fail "$page asks for more"
}

# A rotor from a file: all pictures, elements by their names, and bearings that carry the weight. What is in the directory
# stays there, and a page of an earlier run does not.
mkdir out
echo mine >out/notes.txt
echo old >out/rotor_report.html
expect_exit 0 "$ross" --rotor-report out --speed-rpm 6000 --eccentricity-m 5e-6
expect_files out notes.txt rotor_report.html config.yaml rotor_parts.csv static_line.csv bearing_loads.csv critical_map.csv \
  bearing_stiffness.csv campbell.csv critical_speeds.csv mode_shapes.csv lock_speeds.csv stability.csv deflected_shape.csv report_notes.csv
expect_whole_table out/*.csv
expect_page 7 0
expect_contains stdout 'bearing   Drive end at 0 m: static load '
expect_matches stdout '^stability decrement .*, cross-coupling of [0-9.e+]+ N/m at [0-9.]+ m takes it away$'
expect_contains stdout 'figure    out/rotor_report.html'
for name in 'Drive end' 'Free end'; do
  [[ $(count_rows out/rotor_parts.csv "element == 'bearing' and name == '$name'") == 1 ]] || fail "no bearing $name"
done
[[ $(count_rows out/rotor_parts.csv "element == 'layer'") == 4 ]] || fail 'not three segments and a sleeve'
# Mass of the shaft by its sections, from the file: solid, conical, stepped and the sleeve, 7810 kg/m3, and a disc of 25 kg.
python3 - out/bearing_loads.csv <<'PYTHON' || fail 'the bearings do not carry the weight'
import csv, math, sys
cone = math.pi / 12 * 0.3 * (0.05**2 + 0.05 * 0.07 + 0.07**2)
mass = 25 + 7810 * (math.pi / 4 * (0.3 * 0.05**2 + 0.4 * 0.07**2 + 0.4 * (0.1**2 - 0.07**2)) + cone)
rows = list(csv.DictReader(line for line in open(sys.argv[1]) if not line.startswith("#")))
load = -sum(float(row["load_y_n"]) for row in rows)
print(load, mass * 9.80665)
sys.exit(abs(load / (mass * 9.80665) - 1) > 1e-6)
PYTHON
[[ $(count_rows out/deflected_shape.csv 'True') -gt 50 && $(count_rows out/mode_shapes.csv 'mode == 1') -gt 50 ]] || fail 'the shapes have corners'
expect_contains out/report_notes.csv 'at 100 Hz (6000 rpm) with an eccentricity of 5 um'

# A Jeffcott rotor has no shaft, but modes, stability and an orbit; --quiet prints nothing.
expect_exit 0 "$minimal" --rotor-report out
expect_page 3 4
for picture in rotor static_line critical_map mode_shapes; do
  expect_contains stdout "$picture left out: a Jeffcott rotor is one disc and has no shaft"
done
expect_missing out/rotor_parts.csv
expect_exit 0 "$minimal" --rotor-report out --quiet
expect_empty stdout
expect_empty stderr

# Matrices without bearings beside them.
expect_exit 0 "$top/configs/gallery/matrix_rotor.yaml" --rotor-report out
expect_page 6 1
expect_contains stdout 'critical_map left out: the matrices do not tell the stiffness of the bearings'
expect_contains out/report_notes.csv 'no bending moment'
[[ $(count_rows out/static_line.csv "moment_y_nm == ''") == 7 ]] || fail 'a moment from matrices'

# A disk that is full before the page is whole: the tables are there, and no half page.
(
  ulimit -f 150
  expect_exit 3 "$ross" --rotor-report full
)
expect_missing full/rotor_report.html
expect_exit 0 "$ross" --rotor-report out --check
expect_contains stdout 'rotor report without the stops'
