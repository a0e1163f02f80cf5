#!/usr/bin/env bash
# report.html: of a map that is made or there, whole or not at all, the same bytes, nothing from outside.
source "$(dirname "$0")/support.sh"
rubreport=$4
small=("$minimal" --set sweep.speed_hz.count=3 --set 'sweep.whirl_ratio={values: [0.2, 0.6]}')

# report_exit CODE [ARGUMENT]...
report_exit() {
  local rubsweep=$rubreport
  expect_exit "$@"
}

expect_exit 0 "${small[@]}" --output map --report
expect_files map config.yaml map.csv report.html
expect_matches stdout '^report: map/report.html \([0-9.]+ MB\)$'
expect_empty stderr

# The same map gives the same bytes, by either program, on any number of threads, in any directory.
cp -r map elsewhere
report_exit 0 elsewhere --threads 1
expect_same map/report.html elsewhere/report.html
report_exit 0 map --threads 2 --output other.html --quiet
expect_empty stdout
expect_same map/report.html other.html
# A finished map only gets its report; without --report it stays as it is.
rm map/report.html
touch -d '2001-01-01' map/map.csv
expect_exit 0 "${small[@]}" --output map --report
expect_same map/report.html other.html
[[ map/map.csv -ot other.html ]] || fail 'the map was written again'

# A page that neither loads nor may load anything. D3 names its own address in a comment, SVG its name space.
expect_contains map/report.html "default-src 'none'"
grep -oE '(https?:)?//[[:alnum:].-]+\.[[:alpha:]]+' map/report.html | sort -u >addresses || true
diff addresses - <<'TEXT' >&2 || fail 'the page names other addresses'
http://www.w3.org
https://bost.ocks.org
https://d3js.org
https://github.com
https://www.debian.org
TEXT
! grep -qiE '<(link|iframe|object|embed|base|img)\b|<script[^>]+src|@import|@font-face|srcset=' map/report.html ||
  fail 'the page loads something'
# Kinds and colours are those of the figures and of the terminal.
expect_exit 0 --motion-kinds
diff stdout "$top/scripts/rubplot/motion_kinds.csv" >&2 || fail 'figures have another table: rubsweep --motion-kinds writes it'
expect_contains map/report.html '"motion_kinds":[{"name":"non_contact","label":"no contact","colour":"#F4F4F4"'
expect_exit 1 --motion-kinds "$minimal"
expect_contains stderr '--motion-kinds: is asked for alone, allowed: without CONFIG.yaml'

# Fewer motions than cells: the index says so.
report_exit 0 map --orbits 2 --output few.html --quiet
expect_contains few.html '"recorded":2,'
[[ $(wc -c <few.html) -lt $(wc -c <map/report.html) ]] || fail 'fewer motions take no less room'

# Lines over the map.
printf 'family,kind,point,speed_hz,unbalance\nedge,fold,0,60,0.2\nedge,fold,1,80,0.6\n' >map/boundaries.csv
report_exit 0 map --quiet
expect_contains map/report.html '"family":"edge","kind":"fold"'
echo 'speed_hz,height' >map/boundaries.csv
cp map/report.html before.html
report_exit 3 map
expect_contains stderr 'map/boundaries.csv: no column whirl_ratio or unbalance'
expect_same map/report.html before.html
rm map/boundaries.csv

# No finished map.
report_exit 3 nowhere
expect_contains stderr 'cannot write nowhere/report.html'
sed -i 's/mass_kg: 0.8/mass_kg: 0.9/' elsewhere/config.yaml
report_exit 2 elsewhere
expect_contains stderr 'elsewhere/map.csv: is no map of this configuration'
cp map/config.yaml elsewhere/config.yaml
cp elsewhere/map.csv whole.csv
sed -i '$d' elsewhere/map.csv
report_exit 3 elsewhere
expect_contains stderr 'elsewhere/map.csv: is not as it was written: its sha256 is '
reseal elsewhere/map.csv
report_exit 3 elsewhere
expect_contains stderr 'elsewhere/map.csv: holds 5 cells of 6, there is no row of speed_hz '
# Rows are taken for what they say; a map of an earlier version has no checksum.
{ grep '^#' whole.csv | grep -v -e '^# format ' -e '^# sha256 '; header_of whole.csv; rows whole.csv | sort -t, -k4,4 -k1,1r; } >elsewhere/map.csv
report_exit 0 elsewhere --quiet
[[ $(<stderr) == 'rubreport: elsewhere/map.csv: has no checksum, so whether it is as it was written cannot be told' ]] ||
  fail 'another warning'
cp whole.csv elsewhere/map.csv
mv elsewhere/report.html sorted.html
report_exit 0 elsewhere --quiet
expect_empty stderr
expect_same elsewhere/report.html sorted.html
rm map/report.html
(ulimit -f 100; report_exit 3 map)
expect_missing map/report.html

# The command line.
rubsweep=$rubreport expect_usage_error 'one directory with a map is needed: rubreport DIR'
rubsweep=$rubreport expect_usage_error 'one directory with a map is needed: rubreport DIR' a b
rubsweep=$rubreport expect_usage_error '--orbits: allowed: a number >= 1' map --orbits 0
expect_usage_error '--report needs the whole map: give it to --merge instead of --shard' "${small[@]}" --shard 1/2 --report
report_exit 0 --help
expect_matches stdout '^Examples:$'
report_exit 0 --version
[[ $(head -n 1 stdout) == "rubreport $version" ]] || fail 'another version'
# It is rubreport that writes; it says nothing by its own name.
mkdir alone
cp "$rubsweep" alone/rubsweep
rubsweep=alone/rubsweep expect_exit 3 "${small[@]}" --output unwritten --report
expect_contains stderr "alone/rubreport, which writes it, allowed: build rubreport as well, or install all programs"
expect_missing unwritten/map.csv
printf '#!/bin/sh\nkill -KILL $$\n' >alone/rubreport
chmod +x alone/rubreport
rubsweep=alone/rubsweep expect_exit 70 "${small[@]}" --output killed --report
[[ $(tail -n 1 stderr) == 'rubsweep: rubreport was ended by signal 9; no report was written, the map is as it was' ]] ||
  fail 'another message'
expect_same killed/map.csv map/map.csv
echo 'speed_hz,height' >killed/boundaries.csv
expect_exit 3 "${small[@]}" --output killed --report
expect_contains stderr 'rubsweep: killed/boundaries.csv: no column whirl_ratio or unbalance'
expect_missing killed/report.html
# So it does where who started rubsweep ignores ends of children.
printf '#!/bin/sh\nexec env --ignore-signal=CHLD %s "$@"\n' "$rubsweep" >deaf
chmod +x deaf
rubsweep=./deaf expect_exit 3 "${small[@]}" --output killed --report
# Lines of rubreport stand behind those of rubsweep, also in a file; --progress is handed on.
expect_exit 0 "${small[@]}" --output map --report --progress always
[[ $(tail -n 1 stdout) == 'report: map/report.html'* ]] || fail 'the report is not what is said last'
expect_contains stderr '6 cells'
if [[ -w /dev/full ]]; then
  code=0
  "$rubsweep" "${small[@]}" --output map --report >/dev/full 2>stderr </dev/null || code=$?
  [[ $code == 3 && $(grep -c 'standard output: No space left on device' stderr) == 1 ]] || fail "a full disk: $code"
fi
# Shards are put together and reported in one go.
expect_exit 0 "${small[@]}" --output shards --shard 1/2
expect_exit 0 "${small[@]}" --output shards --shard 2/2
expect_exit 0 "${small[@]}" --output shards --merge --report
expect_same shards/report.html other.html
