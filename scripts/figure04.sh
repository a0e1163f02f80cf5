#!/usr/bin/env bash
# figure04.sh [OUTPUT_BASENAME]: a kick after which rub persists, set A, as OUTPUT_BASENAME.png and .svg.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")

program=$top/build/release/apps/rubtrace
[[ -x $program ]] || { echo "figure04.sh: no $program; cmake --preset release && cmake --build --preset release" >&2; exit 1; }
trace=$top/results/figure04_trace
"$program" "$top/configs/figure06_one_side.yaml" --speed-hz 75 --whirl-ratio 0.3 --revolutions 600 --output "$trace"
"$here/trace.sh" "$trace" "${1:-$top/results/figures/figure04}" 'Rub persists after the kick'
