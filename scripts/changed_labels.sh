#!/usr/bin/env bash
# changed_labels.sh RUBSWEEP_BEFORE MAP_BEFORE RUBSWEEP_AFTER MAP_AFTER: why do two programs call cells of one map by other
# names? MAP_... are directories that the programs wrote, with config.yaml and a map.csv of speed by whirl ratio. Each cell
# whose class, order or orbit differs runs again by both programs, with eleven kicks that differ by up to 1e-8 of their force,
# and, where those do not tell, with four times as many turns. Writes a CSV on stdout: the cell, both labels, how often each
# program gives which label, and what decides:
#   rounding  kicks that differ by next to nothing give the label of the other program, or each program several labels
#   turns     a program gives the label of the other one when it may take more turns
#   program   neither: what the programs do is the reason
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/changed_labels.py" "$@"
