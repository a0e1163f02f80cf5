#!/usr/bin/env bash
# domain_map.sh MAP.csv OUTPUT_BASENAME HEADING [fade]: draws any map.csv over speed and unbalance, as whirl ratio or eccentricity
# as the map was swept, as OUTPUT_BASENAME.png and .svg. Takes natural frequency and the parameters under the heading from
# config.yaml beside the map. A rotor kit has no natural frequency there: its speeds are drawn in Hz, or over the
# frequency given as NATURAL_FREQUENCY_HZ.
# `fade` mixes the colour of a cell with white by its robust_share: of a cell whose motion none of the neighbouring kicks
# leads to, a fifth of the colour is left.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_domain_map.py" "$@"
