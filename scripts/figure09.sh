#!/usr/bin/env bash
# figure09.sh [MAP.csv] [OUTPUT_BASENAME]: draws the domain map of two stops with equal casings as OUTPUT_BASENAME.png and .svg.
# Without a map takes results/figure09_both_sides/map.csv, and computes it first if it is not there.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/map_figure.sh" figure09_both_sides figure09 'Rub domains after a kick, stops on both sides' "$@"
