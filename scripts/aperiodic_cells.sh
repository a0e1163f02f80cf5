#!/usr/bin/env bash
# aperiodic_cells.sh MAP.csv...: the cells of the maps that are neither periodic nor without contact, as CSV on stdout:
# quasi-periodic (ovals with their comb spacing are counted in results/README.md, not listed), chaotic and unsettled
# ones, with the exponent that decided. `map` is the name of the directory.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/aperiodic_cells.py" "$@"
