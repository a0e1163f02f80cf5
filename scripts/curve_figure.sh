#!/usr/bin/env bash
# curve_figure.sh DIR OUTPUT HEADING [MAP.csv]: the earlier name of `rubplot curves`.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" curves "$1" --output "$2" --heading "$3" ${4:+--map "$4"}
