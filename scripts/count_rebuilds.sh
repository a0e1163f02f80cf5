#!/usr/bin/env bash
# count_rebuilds.sh [--build BUILD] [FILE...]: what an edit of each FILE costs, as CSV on stdout: the objects that compile
# again, the programs that are linked again (tests and studies among them), and the project's headers that FILE sees. Looks
# at the commands of a configured build with ninja (build/release) and at the includes of the sources; nothing is compiled.
# Without FILE: files by which the parts of the library were separated.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/count_rebuilds.py" "$@"
