#!/usr/bin/env bash
# work_precision.sh TABLE.csv OUTPUT HEADING: the earlier name of `rubplot work-precision`.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" work-precision "$1" --output "$2" --heading "$3"
