#!/usr/bin/env bash
# ring_findings_test.sh RINGSTAB TOP: the findings of the ring are those of results/ring_findings.txt, each as expected.
set -euo pipefail
diff "$2/results/ring_findings.txt" <("$2/scripts/check_ring_findings.sh" "$1" || echo 'a finding is not as expected')
