#!/usr/bin/env bash
# figure06.sh [MAP.csv] [OUTPUT_BASENAME]: draws the domain map of the one-side stop as OUTPUT_BASENAME.png and .svg.
# Without a map takes results/figure06_one_side/map.csv, and computes it first if it is not there.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/map_figure.sh" figure06_one_side figure06 'Rub domains after a kick, stop on one side' "$@"
