#!/usr/bin/env bash
# sweep.refine: the computed cells are those of the full map, the others are painted as they are there, and neither
# threads nor a kill change which cells are computed.
source "$(dirname "$0")/support.sh"

grid=("$minimal" --set 'sweep={speed_hz: {from: 60, to: 100, count: 41}, whirl_ratio: {from: 0.1, to: 0.9, count: 33}}')
refine=(--set 'sweep.refine={levels: 3, probes: 1}')
expect_exit 0 "${grid[@]}" "${refine[@]}" --explain
expect_matches stdout 'refined: from every 8th cell on, .*square of [0-9]+ x [0-9]+ cells'
expect_exit 0 "${grid[@]}" --output full --quiet
header+=,level
expect_exit 0 "${grid[@]}" "${refine[@]}" --output whole --threads 1
expect_files whole config.yaml map.csv painted.csv
expect_whole_rows whole/map.csv
expect_matches stderr 'refined: [0-9]+ of 1353 cells computed'
computed=$(rows whole/map.csv | wc -l)
((computed < 1353 && computed > 100)) || fail "$computed of 1353 cells were computed"
# Every computed row is the row of the full map, with its level behind it.
rows whole/map.csv | cut -d, -f1-29 | grep -vxF -f <(rows full/map.csv) && fail 'a computed cell is another one'
[[ $(cells whole/map.csv level | sort -u | tr '\n' ' ') == '0 1 2 3 ' ]] || fail 'not the levels'

PYTHONPATH=$top/scripts python3 -B - <<'END' || fail 'painted cells differ from the full map'
from rubplot import csv_table
def motions(path):
    return {(r["speed_hz"], r["whirl_ratio"]): (r["class"], r["order"]) for r in csv_table.read_table(path)}
full, painted, computed = (motions(path) for path in ("full/map.csv", "whole/painted.csv", "whole/map.csv"))
assert full.keys() == painted.keys()
assert all(painted[cell] == motion for cell, motion in computed.items())
flags = [row["computed"] for row in csv_table.read_table("whole/painted.csv", "computed")]
assert flags.count("1") == len(computed) and flags.count("0") == len(full) - len(computed)
equal = sum(painted[cell] == motion for cell, motion in full.items())
print(f"{len(computed)} of {len(full)} cells computed, {equal} equal")
assert equal >= 0.98 * len(full)
END

expect_exit 0 "${grid[@]}" "${refine[@]}" --output threads --threads 3 --quiet
expect_same threads/map.csv whole/map.csv
expect_same threads/painted.csv whole/painted.csv
# One that is not there is written where the map is, and goes with a map that is computed anew.
rm threads/painted.csv
expect_exit 0 "${grid[@]}" "${refine[@]}" --output threads --quiet
expect_same threads/painted.csv whole/painted.csv
expect_exit 0 "${grid[@]}" --output threads --fresh --quiet
expect_files threads config.yaml map.csv
# In the first round and in a later one.
for cells in 20 $((computed - 50)); do expect_resumed $cells whole "${grid[@]}" "${refine[@]}"; done
expect_exit 0 "${grid[@]}" "${refine[@]}" --output killed
expect_contains stderr 'the map is there'

# In shards. At the same time they wait for each other's cells and end with the whole map; one alone says what it misses.
# Also where the last one comes when the first has had nothing to do for a while.
for i in 1 2 3; do
  "$rubsweep" "${grid[@]}" "${refine[@]}" --output together --shard $i/3 --threads 1 >"shard_$i" 2>&1 </dev/null &
  shard[i]=$!
  ((i < 2)) || sleep 1
done
for i in 1 2 3; do wait "${shard[i]}" || fail "shard $i ended with $?: $(cat "shard_$i")"; done
expect_contains shard_1 'the refined map is complete: rubsweep '
expect_exit 0 "${grid[@]}" "${refine[@]}" --output together --merge
expect_same together/map.csv whole/map.csv
expect_files together config.yaml map.csv painted.csv
# 75: it did what it could, others must go on.
expect_exit 75 "${grid[@]}" "${refine[@]}" --output alone --shard 1/2
expect_matches stdout '^the refined map wants [0-9]+ cells of other shards before it can say what it wants of this one: run every shard'
expect_exit 3 "${grid[@]}" "${refine[@]}" --output alone --merge
expect_matches stderr 'nothing to merge yet: the refined map wants [0-9]+ cells more, of shards? .*2/2.*allowed: first'
expect_exit 75 "${grid[@]}" "${refine[@]}" --output alone --shard 2/2
lines=$(cat alone/map.shard-*.journal | grep -c ',kick,')
expect_exit 0 "${grid[@]}" "${refine[@]}" --output alone
expect_contains stderr "$lines of 1353 cells were finished before"
expect_same alone/map.csv whole/map.csv
# The page paints the cells that were not computed, and holds motions of those that were.
expect_exit 0 "${grid[@]}" "${refine[@]}" --output whole --report
expect_matches stdout '^report: whole/report.html'
expect_contains whole/report.html "<li>Refined: $computed of 1353 cells computed"
expect_contains whole/report.html '<li>Boundaries: uncertainty exponent'
expect_contains whole/report.html "\"recorded\":$computed,"
if command -v gnuplot >/dev/null; then
  rubplot map whole --output picture.png
  [[ -s picture.png ]] || fail 'there is no picture.png'
fi
