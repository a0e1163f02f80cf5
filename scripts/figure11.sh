#!/usr/bin/env bash
# figure11.sh [MAP.csv] [OUTPUT_BASENAME]: draws the domain map of the centred annulus as OUTPUT_BASENAME.png and .svg.
# Without a map takes results/figure11_annulus/map.csv, and computes it first if it is not there.
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/map_figure.sh" figure11_annulus figure11 'Rub domains after a kick, centred annulus' "$@"
