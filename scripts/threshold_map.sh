#!/usr/bin/env bash
# threshold_map.sh MAP.csv OUTPUT_BASENAME HEADING: draws the thresholds of a map made with study.kind threshold, over
# the same axes as domain_map.sh, with contours, as OUTPUT_BASENAME.png and .svg. Needs config.yaml beside the map.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/draw_threshold_map.py" "$@"
