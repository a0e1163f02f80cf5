#!/usr/bin/env bash
# study.kind basin and robustness: probability: what is counted is what single runs do, and a killed sweep goes on.
source "$(dirname "$0")/support.sh"

draw=("$minimal" --set 'study={kind: basin, samples: 60, over: [{key: kick.force_n, from: 0, to: 400}]}')
plain=$header
header+=,attractors,rub_probability,basins,failed_samples
expect_exit 0 "${draw[@]}" --explain
expect_contains stdout 'basins: in each cell, where 60 starts lead, drawn over kick.force_n from 0 to 400'
expect_exit 0 "${draw[@]}" --output whole --threads 1
expect_whole_rows whole/map.csv
[[ $(count_rows whole/map.csv 'failed_samples == 0 and 0 <= rub_probability <= 1') == 24 ]] || fail 'not a share in every row'
expect_matches whole/map.csv ',2,0\.[0-9]+,non_contact 0\.[0-9]+\+-0\.[0-9]+ \([0-9.]+ mm\); subharmonic 1/'

# The same 60 kicks as an axis of a map: van der Corput's numbers times 400.
forces=$(python3 -c 'print([400 * sum((n >> k & 1) / 2 ** (k + 1) for k in range(8)) for n in range(1, 61)])')
one_cell 70 0.4
expect_exit 0 "$minimal" "${cell[@]}" --set "sweep.x={key: kick.force_n, values: $forces}" --output kicks
rubbing=$(cells kicks/map.csv class | grep -vc non_contact)
share=$(cells whole/map.csv speed_hz whirl_ratio rub_probability | grep '^70,0.4,' | cut -d, -f3)
python3 -c "import sys; sys.exit(abs($share - $rubbing / 60) > 1e-12)" || fail "$share is not $rubbing of 60"

expect_resumed 3 whole "${draw[@]}"

header=$plain,robust_share
expect_exit 0 "$minimal" --output share --set response.robustness=probability --set response.robustness_neighbours=4
expect_whole_rows share/map.csv
[[ $(count_rows share/map.csv 'robust_share in (0, 0.25, 0.5, 0.75, 1)') == 24 ]] || fail 'not shares of four'
diff <(cells share/map.csv robust) <(cells share/map.csv robust_share | sed 's/^1$/yes/; s/^0.*/no/') ||
  fail 'robust is not whether all neighbours agree'
