#!/usr/bin/env bash
# rubline: bifurcation diagram and cascade along a line. The fourth argument is rubsweep, the program of the map.
source "$(dirname "$0")/support.sh"
sweep=$4
files=(bifurcation.csv cascade.csv config.yaml line.csv)

# Command line.
expect_help along from to count speed-hz speed-rpm whirl-ratio eccentricity-m unbalance-g-mm kick up down figure cascade-figure threads progress
along=("$minimal" --along speed_hz)
expect_usage_error 'a configuration file is needed' --along speed_hz
expect_usage_error 'what changes along the line is needed: --along KEY' "$minimal"
expect_usage_error '--from and --to belong together' "${along[@]}" --from 50
expect_usage_error '--count belongs to --from and --to' "${along[@]}" --count 5
expect_usage_error '--to: allowed: a number > --from' "${along[@]}" --from 50 --to 50
expect_usage_error '--count: allowed: a number from 2 to 10000' "${along[@]}" --from 50 --to 60 --count 1
expect_usage_error '--speed-hz, --speed-rpm: the line runs along the speed' "${along[@]}" --speed-hz 50
expect_usage_error '--speed-hz and --speed-rpm exclude each other' "$minimal" --along whirl_ratio --speed-hz 90 --speed-rpm 5400
expect_usage_error '--along speed_rpm: a line runs along SI units, allowed: --along speed_hz' "$minimal" --along speed_rpm
expect_usage_error '--whirl-ratio and --eccentricity-m exclude each other' "${along[@]}" --whirl-ratio 0.1 --eccentricity-m 0.1
expect_usage_error '--whirl-ratio, --eccentricity-m, --unbalance-g-mm: the line runs along the unbalance' "$minimal" --along whirl_ratio --whirl-ratio 0.1
expect_usage_error 'the sweep has 4 values for it: the place of the line is needed' "${along[@]}"
expect_usage_error 'the sweep has 6 values for it: the place of the line is needed, --speed-hz S' "$minimal" --along whirl_ratio
expect_usage_error 'the values of eccentricity_m are needed: --from A --to B' "$minimal" --along eccentricity_m --speed-hz 60
expect_usage_error '--from: allowed: a speed > 0' "${along[@]}" --from -5 --to 50 --whirl-ratio 0.2
expect_exit 2 "$minimal" --along stops.0.clearence_m --from 1e-3 --to 2e-3 --speed-hz 60 --whirl-ratio 0.2
expect_contains stderr "stops.0.clearence_m: unknown key (did you mean 'clearance_m'?)"
expect_exit 2 "$minimal" --along rotor.damping_ratio --from 0.01 --to 1.5 --speed-hz 60 --whirl-ratio 0.2
expect_contains stderr 'rotor.damping_ratio: '
expect_missing results

# From the kick the rows are those of the map.
expect_exit 0 "${along[@]}" --whirl-ratio 0.6 --output line
expect_files line "${files[@]}"
expect_contains line/line.csv '# along speed_hz'
[[ $(grep -v '^#' line/line.csv | head -n 1) == "pass,value,$header" ]] || fail 'another header of line.csv'
[[ $(header_of line/bifurcation.csv) == pass,value,speed_hz,class,order,point,x_m,y_m,vx_m_per_s,vy_m_per_s ]] ||
  fail 'another header of bifurcation.csv'
[[ $(header_of line/cascade.csv) == pass,value,speed_hz,order,frequency_hz,amplitude_m ]] || fail 'another header of cascade.csv'
expect_matches stdout '^kick +90 to 90  subharmonic 1/2$'
rubline=$rubsweep rubsweep=$sweep
expect_exit 0 line/config.yaml --set 'sweep.speed_hz={from: 50, to: 150, count: 6}' --set 'sweep.whirl_ratio={values: [0.6]}' \
  --output map --quiet
rubsweep=$rubline
diff <(rows map/map.csv) <(grep '^kick,' line/line.csv | cut -d, -f3-) || fail 'other rows than the map'
# A period of two turns has two points, and lines at halves of the speed.
[[ $(count_rows line/bifurcation.csv 'value == 90 and order == 2') == 2 ]] || fail 'not two points'
[[ $(count_rows line/cascade.csv 'value == 90 and abs(order) == 0.5') == 2 ]] || fail 'no lines at one half'
[[ $(count_rows line/cascade.csv 'value == 90 and 2 * order != round(2 * order)') == 0 ]] || fail 'lines off the halves'

# Up and down, on any number of threads, with what the neighbour does.
expect_exit 0 "${along[@]}" --from 60 --to 120 --count 13 --whirl-ratio 0.6 --up --down --threads 1 --output one --quiet
expect_empty stdout
expect_exit 0 "${along[@]}" --from 60 --to 120 --count 13 --whirl-ratio 0.6 --up --down --threads 2 --output two
for file in "${files[@]}"; do expect_same "one/$file" "two/$file"; done
[[ $(grep -c '^up,.*,handed_on,' one/line.csv) == 12 && $(grep -c '^down,.*,handed_on,' one/line.csv) == 12 ]] ||
  fail 'cells that do not start from their neighbour'
[[ $(grep -c ',kick,' one/line.csv) == 2 ]] || fail 'the first cells are not kicked'

# An unbalance in g mm belongs to the mass of each cell, wherever it is said.
heavier=("$minimal" --along rotor.mass_kg --from 0.5 --to 1 --count 2 --quiet)
expect_exit 0 "${heavier[@]}" --speed-hz 90 --unbalance-g-mm 240 --output by_option
expect_exit 0 "${heavier[@]}" --set 'sweep={speed_hz: {values: [90]}, unbalance_g_mm: {values: [240]}}' --output by_sweep
[[ $(count_rows by_option/line.csv 'abs(eccentricity_m * value - 240e-6) < 1e-18') == 2 ]] || fail 'another unbalance'
# Behind the columns of a map the sweep's own unit has one.
diff <(grep '^kick,' by_option/line.csv | cut -d, -f3-31) <(grep '^kick,' by_sweep/line.csv | cut -d, -f3-31) ||
  fail 'the unbalance of the sweep is another'

# Along the unbalance and along any number.
expect_exit 0 "$minimal" --along whirl_ratio --speed-hz 90 --output ratio --quiet
[[ $(cells ratio/line.csv value whirl_ratio | head -n 2) == $'0.2,0.2\n0.4,0.4' ]] || fail 'another line along the whirl ratio'
expect_exit 0 "$minimal" --along stops.0.friction.stribeck.3 --from 0 --to 0.2 --count 3 --speed-hz 90 --whirl-ratio 0.6 --output mu
expect_contains mu/line.csv '# along stops.0.friction.stribeck.3'
[[ $(cells mu/line.csv value | tr '\n' ' ') == '0 0.1 0.2 ' ]] || fail 'other values along the friction'
one_cell 90 0.6
rubsweep=$sweep expect_exit 0 "$minimal" "${cell[@]}" --set stops.0.friction.stribeck.3=0.2 --output mu_map --quiet
[[ $(rows mu_map/map.csv) == "$(grep '^kick,0.2,' mu/line.csv | cut -d, -f3-)" ]] || fail 'another row than that of the changed machine'

# The place in other units: 5400 revolutions per minute are 90 per second, 240 g mm on 0.8 kg 0.3 mm.
mu=(--along stops.0.friction.stribeck.3 --from 0 --to 0.2 --count 3 --quiet)
expect_exit 0 "$minimal" "${mu[@]}" --speed-hz 90 --eccentricity-m 3e-4 --output si
expect_exit 0 "$minimal" "${mu[@]}" --speed-rpm 5400 --unbalance-g-mm 240 --output others
expect_same others/line.csv si/line.csv

# Axes over keys: what the line does not run along must be said, an axis that it runs along gives its values.
cat >axes.yaml <<END
base: $minimal
sweep:
  speed_hz: 90
  whirl_ratio: 0.6
  x: {key: kick.force_n, values: [100, 200, 400]}
  y: {keys: [stops.0.casing.mass_kg, rotor.damping_ratio], factors: [1, 0.4], values: [0.04, 0.06]}
END
expect_exit 2 axes.yaml --along speed_hz
[[ $(cat stderr) == "axes.yaml:5:6: sweep.x: kick.force_n has 3 values, and the line runs along speed_hz, allowed: --set \
kick.force_n=VALUE, --set sweep.x.values=[VALUE], or --along kick.force_n
axes.yaml:6:6: sweep.y: stops.0.casing.mass_kg has 2 values, and the line runs along speed_hz, allowed: --set \
stops.0.casing.mass_kg=VALUE, --set sweep.y.values=[VALUE], or --along stops.0.casing.mass_kg" ]] || fail 'another refusal'
expect_exit 2 axes.yaml --along kick.force_n
expect_contains stderr 'axes.yaml:6:6: sweep.y: stops.0.casing.mass_kg has 2 values'
expect_exit 0 axes.yaml --along kick.force_n --set sweep.y.values=[0.06] --output along_x --quiet
rubsweep=$sweep expect_exit 0 axes.yaml --output axes_map --quiet
[[ $(grep '^kick,' along_x/line.csv | cut -d, -f2-) == "$(rows axes_map/map.csv | tail -n 3 | awk -F, -v OFS=, '{v = $30; NF = 29; print v, $0}')" ]] ||
  fail 'the rows along x are not those of the map'
# Along either of two tied keys both change; an axis whose keys are set is left to them.
expect_exit 0 axes.yaml --along rotor.damping_ratio --set kick.force_n=400 --output along_y --quiet
[[ $(grep '^kick,' along_y/line.csv | cut -d, -f2-) == "$(rows axes_map/map.csv | sed -n '3p;6p' | awk -F, -v OFS=, '{v = $32; NF = 29; print v, $0}')" ]] ||
  fail 'the rows along y are not those of the map'
expect_exit 0 axes.yaml --along speed_hz --set kick.force_n=400 --set sweep.y.values=[0.06] --output held --quiet
[[ $(grep '^kick,' held/line.csv | cut -d, -f3-) == "$(rows axes_map/map.csv | tail -n 1 | cut -d, -f1-29)" ]] || fail 'other keys are held'

# A cell that fails is a row.
expect_exit 4 "$minimal" --along speed_hz --from 29 --to 31 --count 3 --whirl-ratio 0.2 --set rotor.damping_ratio=0 --up --output failed
[[ $(cells failed/line.csv start | tr '\n' ' ') == 'kick  kick ' && $(cells failed/line.csv class status | sed -n 2p) == failed,unreachable ]] ||
  fail "other rows: $(rows failed/line.csv)"

# Interrupted, what is finished is written.
slow=("$top/configs/benchmark/one_side.yaml" --along speed_hz --from 150 --to 154 --count 9000 --whirl-ratio 0.6 --kick --output slow)
"$rubsweep" "${slow[@]}" >stdout 2>stderr </dev/null &
pid=$!
sleep 1
kill -INT "$pid" 2>/dev/null || true
code=0
wait "$pid" || code=$?
if [[ $code != 0 ]]; then
  [[ $code == 130 ]] || fail "exit code $code, expected 130"
  expect_matches stderr '^rubline: interrupted; [0-9]+ of 9000 cells are written$'
  written=$(sed -E 's/.*interrupted; ([0-9]+) of.*/\1/' stderr)
  [[ $(grep -c '^kick,' slow/line.csv) == "$written" ]] || fail "not $written rows in line.csv"
fi

# Pictures, where there is gnuplot.
command -v gnuplot >/dev/null || exit 0
expect_exit 0 "${along[@]}" --from 60 --to 120 --count 13 --whirl-ratio 0.6 --kick --up --down --output drawn \
  --figure pictures/bifurcation.svg --cascade-figure pictures/cascade.svg
expect_empty stderr
for text in 'Bifurcation diagram at whirl ratio 0.6' 'shaft speed (Hz)' 'subharmonic 1/2' upward 'clearance at rest'; do
  expect_contains pictures/bifurcation.svg "$text"
done
for text in 'Cascade of full spectra at whirl ratio 0.6' 'order (× shaft speed)' backward 'from the kick' downward; do
  expect_contains pictures/cascade.svg "$text"
done
rubplot line drawn --output out 2>stderr || fail 'rubplot line'
[[ -s out.png ]] || fail 'there is no out.png'
# Text in the files becomes no command.
sed -i -E 's/,subharmonic_[0-9]+/,"; system("touch pwned"); "/' drawn/line.csv
reseal drawn/line.csv
rubplot cascade drawn --output evil >/dev/null 2>&1 && fail 'rubplot cascade drew a kind that is none'
rubplot line drawn --output evil >/dev/null 2>&1 && fail 'rubplot line drew a kind that is none'
expect_missing pwned
