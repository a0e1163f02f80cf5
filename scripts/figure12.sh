#!/usr/bin/env bash
# figure12.sh [MAP.csv] [OUTPUT_BASENAME]: draws the domain map of the annulus with offset as OUTPUT_BASENAME.png and .svg.
# Without a map takes results/figure12_annulus_offset/map.csv, and computes it first if it is not there.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/map_figure.sh" figure12_annulus_offset figure12 'Rub domains after a kick, annulus with offset' "$@"
