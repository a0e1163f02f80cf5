#!/usr/bin/env bash
# check_findings.sh [--programs DIR] [--maps DIR] [--machine NAME=DIR]... [--expected FILE] | --brief DIR: what Ishibashi &
# Kawai report of each contact configuration, measured on our maps. Prints every finding: what the paper says, what is
# counted over which cells, the threshold and why; then for each machine the number that decides, the same without any
# filter, and one of `holds`, `partly`, `not reproduced` (`no map` where the machine has none of that kind).
# The machines of configs/ take their maps from MAPS/CONFIG_STEM (results/ by default), computed first where missing. Each
# --machine adds one whose maps (map.csv, config.yaml) are in DIR/one_side, both_sides, both_sides_unequal, annulus and
# annulus_offset, as many of them as it has.
# A finding that does not hold is a result, not an error; with --expected the exit code is 1 when a verdict differs from
# that in FILE, a table as printed here (results/findings.txt). Measures may differ: cells on the edge of a domain do.
# With --brief a line for each finding, of the machine of DIR alone.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/check_findings.py" "$@"
