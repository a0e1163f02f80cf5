#!/usr/bin/env bash
# threshold_map.sh MAP.csv OUTPUT HEADING: the earlier name of `rubplot threshold`.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" threshold "$1" --output "$2" --heading "$3"
