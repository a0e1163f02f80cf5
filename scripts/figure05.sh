#!/usr/bin/env bash
# figure05.sh [OUTPUT_BASENAME]: a kick after which rub dies out, set A, as OUTPUT_BASENAME.png and .svg.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")

program=$top/build/release/apps/rubtrace
[[ -x $program ]] || { echo "figure05.sh: no $program; cmake --preset release && cmake --build --preset release" >&2; exit 1; }
trace=$top/results/figure05_trace
"$program" "$top/configs/figure06_one_side.yaml" --speed-hz 90 --whirl-ratio 0.3 --revolutions 600 --output "$trace"
"$here/trace.sh" "$trace" "${1:-$top/results/figures/figure05}" 'Rub dies out after the kick'
