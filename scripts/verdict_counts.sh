#!/usr/bin/env bash
# verdict_counts.sh RUBSCOPE SET: how often is RUBSCOPE right about the recordings of a set of rubdata? Each recording of the
# directory SET is judged by the set's own description of its instrument. Writes a CSV on stdout: the class in the labels
# ("subharmonic 1/3" with its order), what RUBSCOPE says, and how many recordings that is; classes that rubscope does not
# tell from each other on purpose stay apart. Half a minute for 500 recordings.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/verdict_counts.py" "$@"
