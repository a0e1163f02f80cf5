#!/usr/bin/env bash
# check_ring_findings.sh [RINGSTAB]: what Lesaffre, Sinou and Thouverez (JSV 299, 2007) report for each figure and Table 1,
# measured with ringstab. Prints a table: figure, claim, measured, holds or not; then the errata. Exits 1 when a claim that
# is expected to hold does not, or one that is known not to suddenly holds.
set -euo pipefail
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$(dirname "${BASH_SOURCE[0]}")
exec python3 "$(dirname "${BASH_SOURCE[0]}")/analysis/check_ring_findings.py" "$@"
