#!/usr/bin/env bash
# figure06.sh [MAP.csv [OUTPUT]]: the domain map of the stop on one side.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 06 ${1:+--map "$1"} ${2:+--output "$2"}
