#!/usr/bin/env bash
# study.kind threshold: what a row says of its kicks is what single runs do, killed sweeps go on, shards agree, and the
# thresholds are drawn.
source "$(dirname "$0")/support.sh"

scan=("$minimal" --set 'study={kind: threshold, key: kick.force_n, from: 10, to: 400, count: 12, scale: log}')
header+=,threshold,threshold_motion,rub_intervals,probes,failed_probes
expect_exit 0 "${scan[@]}" --explain
expect_contains stdout 'threshold: in each cell, after which of 12 values of kick.force_n from 10 to 400'
expect_exit 0 "${scan[@]}" --output whole --threads 1
expect_whole_rows whole/map.csv
# The columns of every map are those of the map without the study.
expect_exit 0 "$minimal" --output plain
diff <(rows plain/map.csv) <(rows whole/map.csv | cut -d, -f1-29) || fail 'the study changes the map'
# Above a whirl ratio of 1 nothing is kicked.
one_cell 75 1.1
expect_exit 0 "${scan[@]}" "${cell[@]}" --output contact
expect_matches contact/map.csv ',contact,[0-9.e-]+,[0-9.]+,,,subharmonic_2,,,,,$'

# Single runs on both sides of the smallest threshold.
cells whole/map.csv speed_hz whirl_ratio threshold threshold_motion >found
IFS=, read -r speed_hz whirl_ratio threshold motion < <(grep -m 1 ',subharmonic' found)
one_cell "$speed_hz" "$whirl_ratio"
expect_exit 0 "$minimal" "${cell[@]}" --output above --set "kick.force_n=$threshold"
expect_contains stdout "$motion"
expect_exit 0 "$minimal" "${cell[@]}" --output below --set "kick.force_n=$(python3 -c "print($threshold * 0.999)")"
expect_contains stdout non_contact

# Killed on the way, and in three parts.
expect_resumed 3 whole "${scan[@]}"
for shard in 1 2 3; do expect_exit 0 "${scan[@]}" --output parts --shard $shard/3; done
expect_exit 0 "${scan[@]}" --output parts --merge
expect_same parts/map.csv whole/map.csv

# The same of the phase of the kick, which no configuration has to give.
one_cell 77 0.4
expect_exit 0 "$minimal" "${cell[@]}" --output phase \
  --set 'study={kind: threshold, key: kick.phase_deg, from: 0, to: 350, count: 36}'
expect_matches phase/map.csv ',[0-9.]+,subharmonic 1/[0-9]+,[0-9.]+\.\.[0-9.]+ '

command -v gnuplot >/dev/null || { echo 'no gnuplot: pictures are not looked at'; exit 0; }
rubplot threshold whole --output picture 2>stderr
expect_empty stderr
expect_contains picture.svg 'smallest after which rub goes on'
expect_contains picture.svg 'contours at'
[[ -s picture.png ]] || fail 'there is no picture.png'
code=0
rubplot threshold plain --output none 2>stderr || code=$?
[[ $code == 3 ]] || fail "exit code $code"
expect_contains stderr "no column 'threshold'"
