#!/usr/bin/env bash
# lock_islands.sh NATURAL_FREQUENCY_HZ MAP.csv...: do the islands of rub of a map of a Jeffcott rotor contain lock speeds, 2, 3
# and 5 times its natural frequency? An island is a set of rubbing cells that touch along their sides; it contains a lock
# speed where one lies between its slowest and its fastest cell, or half a step beside them. A stretch begins at a cell
# that rubs whose slower neighbour does not. Prints for each map how many islands contain one, how many cells these have, how
# many stretches begin up to 12 % above one, and how many of all speeds lie there.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/lock_islands.py" "$@"
