#!/usr/bin/env bash
# rubbasin: what a slice says of a start is what a run of its own says, a killed slice goes on, and it is drawn.
source "$(dirname "$0")/support.sh"
sweep=$4

expect_help cell plane grid from to figure fresh threads progress
slice=("$minimal" --cell 70,0.4 --plane y,vy --grid 13x11 --from -2e-3,-1 --to 1e-3,1)
expect_exit 0 "${slice[@]}" --output whole --threads 1
expect_files whole attractors.csv config.yaml map.csv slice.csv
expect_contains stdout '13 x 11 starts, y_m from -0.002 to 0.001, vy_m_per_s from -1 to 1'
expect_matches stdout '^ +[0-9]+ +[0-9.]+ \+- [0-9.]+ %  attractor 1: '
expect_matches stdout '^ +[0-9]+ +[0-9.]+ \+- [0-9.]+ %  attractor 2: '
expect_matches stdout '^basin entropy 0\.[0-9]+ '
expect_matches stdout '^boundary basin entropy 0\.[0-9]+ '
expect_matches stdout '^uncertainty exponent'
expect_contains whole/slice.csv 'y_m,vy_m_per_s,attractor,label,status'
[[ $(count_rows whole/slice.csv 'status == "ok"') == 143 ]] || fail 'not a row for each start'
# Shares are what the rows count to, the most frequent first.
PYTHONPATH=$top/scripts python3 -B - <<'END' || fail 'shares are not those of the rows'
import collections
from rubplot import csv_table
rows = list(csv_table.read_table("whole/slice.csv"))
found = list(csv_table.read_table("whole/attractors.csv"))
counts = collections.Counter(row["attractor"] for row in rows)
assert [a["attractor"] for a in found] == [str(i + 1) for i in range(len(found))]
assert [int(a["starts"]) for a in found] == [counts[a["attractor"]] for a in found] == sorted(counts.values(), reverse=True)
assert abs(sum(float(a["share"]) for a in found) - 1) < 1e-12
for a in found:
    row = next(r for r in rows if r["attractor"] == a["attractor"])
    assert [row[n] for n in ("y_m", "vy_m_per_s", "label")] == [a[n] for n in ("y_m", "vy_m_per_s", "label")]
END

# By another route: single starts as configurations of their own, and the map by rubsweep; both solvers.
one_cell 70 0.4
while IFS=, read -r y vy label; do
  for method in exact adaptive; do
    "$sweep" "$minimal" "${cell[@]}" --set "start={y_m: $y, vy_m_per_s: $vy}" --set solver.method=$method --output one \
      --fresh >stdout 2>stderr
    expect_contains stdout "$label"
    expect_contains one/map.csv ,ok,state,
  done
done < <(cells whole/attractors.csv y_m vy_m_per_s label)
"$sweep" whole/config.yaml --output map --quiet
expect_same map/map.csv whole/map.csv

# Killed, with any number of threads, and found whole.
expect_resumed 20 whole "${slice[@]}"
expect_exit 0 "${slice[@]}" --output threads --threads 3 --quiet
diff -r threads whole >&2 || fail 'the number of threads changes the slice'
expect_empty stdout
rm whole/slice.csv
expect_exit 0 "${slice[@]}" --output whole
expect_contains stderr 'rubbasin: the map is there, nothing is left to do'
expect_same whole/slice.csv threads/slice.csv
other=("${slice[@]/y,vy/x,vy}")
expect_exit 2 "${other[@]}" --output whole
expect_contains stderr 'is a finished map of another configuration'
expect_exit 0 "${other[@]}" --output whole --fresh --quiet
expect_contains whole/slice.csv 'x_m,vy_m_per_s,attractor'
# The remains of a killed --fresh are no slice of another plane.
killed_at 20 other "${slice[@]}"
expect_missing other/slice.csv

# Casings and keys; the study and the kick of a configuration do not matter to a plane of states.
expect_exit 0 "$minimal" --cell 70,0.4 --plane casing0.x,vx --grid 3x2 --output casing \
  --set 'study={kind: basin, samples: 5, over: [{key: kick.force_n, from: 0, to: 400}]}'
expect_matches casing/slice.csv '^-0.002,-0.879[0-9]+,[1-9],[a-z_]+'
expect_contains casing/slice.csv casing0_x_m,vx_m_per_s,attractor,label,status
# Nor does how a map says what is robust.
expect_exit 0 "$minimal" --cell 70,0.4 --plane vx,vy --grid 2x2 --output probable --quiet \
  --set response.robustness=probability --set response.robustness_neighbours=4
# A state takes the place of a start at rest as it takes that of a kick.
expect_exit 0 "$minimal" --cell 70,0.4 --plane vx,vy --grid 2x2 --output stated --quiet
expect_exit 0 "$minimal" --cell 70,0.4 --plane vx,vy --grid 2x2 --output rested --quiet --set start=rest
expect_same stated/slice.csv rested/slice.csv
expect_exit 0 "$minimal" --cell 70,0.4 --plane kick.force_n,kick.angle_deg --grid 3x2 --from 50,60 --to 400,120 --output kicks
expect_contains kicks/slice.csv kick.force_n,kick.angle_deg,attractor
expect_contains kicks/map.csv ,kick,
"$sweep" "$minimal" "${cell[@]}" --set kick.force_n=225 --set kick.angle_deg=120 --output one --fresh >stdout 2>stderr
expect_contains stdout "$(cells kicks/slice.csv kick.force_n kick.angle_deg label | sed -n 's/^225,120,//p')"

# Without a plane the slice goes towards the first stop, wherever that is.
for angle in -90:y_m,vy_m_per_s 60:y_m,vy_m_per_s 130:y_m,vy_m_per_s 30:x_m,vx_m_per_s 180:x_m,vx_m_per_s; do
  expect_exit 0 "$minimal" --cell 70,0.4 --grid 3x3 --set "stops.0.angle_deg=${angle%:*}" --output "towards${angle%:*}"
  expect_contains "towards${angle%:*}/slice.csv" "${angle#*:},attractor"
  [[ $(cells "towards${angle%:*}/slice.csv" label | sort -u) != non_contact ]] || fail "no start meets a stop at ${angle%:*} degrees"
done

expect_usage_error 'the cell is needed: --cell SPEED_HZ,UNBALANCE' "$minimal"
expect_usage_error "--plane x,z: there is no 'z', allowed: two of x, y, vx, vy" "$minimal" --cell 70,0.4 --plane x,z
expect_usage_error '--plane x,x: allowed: two different numbers' "$minimal" --cell 70,0.4 --plane x,x
expect_usage_error '--plane: there is no stop 1, allowed: casing0 to casing0' "$minimal" --cell 70,0.4 --plane x,casing1.x
expect_usage_error '--plane: the casing of stop 0 is rigid' "$minimal" --cell 70,0.4 --plane x,casing0.x --set stops.0.casing=rigid
expect_usage_error '--plane: kick.force_n has no usual range' "$minimal" --cell 70,0.4 --plane kick.force_n,kick.phase_deg
expect_usage_error '--grid 1x5: allowed: NxM, both from 2 to 10000' "$minimal" --cell 70,0.4 --grid 1x5
expect_usage_error '--from and --to belong together' "$minimal" --cell 70,0.4 --from 0,0
expect_usage_error '--to 1: allowed: two numbers parted by a comma' "$minimal" --cell 70,0.4 --from 0,0 --to 1
expect_usage_error '--from, --to: allowed: each number of --to larger' "$minimal" --cell 70,0.4 --from 0,0 --to 1,0
expect_exit 2 "$minimal" --cell 70,0.4 --plane kick.mass,x --from 0,0 --to 1,1
expect_contains stderr 'kick.mass'

command -v gnuplot >/dev/null || { echo 'no gnuplot: pictures are not looked at'; exit 0; }
expect_exit 0 "${slice[@]}" --output drawn --figure picture.png --quiet
rubplot basin drawn --output again 2>stderr
expect_empty stderr
expect_contains again.svg 'displacement y of the rotor (mm)'
expect_contains again.svg 'wall at rest'
expect_contains again.svg 'no contact'
[[ -s picture.png && -s again.png ]] || fail 'there is no picture'
