#!/usr/bin/env bash
# domain_map.sh MAP.csv OUTPUT HEADING [fade]: the earlier name of `rubplot map`.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" map "$1" --output "$2" --heading "$3" ${4:+--fade}
