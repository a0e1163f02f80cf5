#!/usr/bin/env bash
# slowest_cells.sh BIN CELLS SEED LIMIT_S [DIRECTORY [METHOD]]: processor times of CELLS random cells by BIN/rubsweep,
# one process and one thread each, as CSV on stdout, the slowest first; a cell that takes LIMIT_S is stopped. The
# machines are drawn by scripts/analysis/random_cells.py, the same for the same SEED; DIRECTORY keeps their
# configurations. METHOD leaves out the cells of other solvers: `auto` those for which an adaptive stepper was drawn.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/slowest_cells.py" "$@"
