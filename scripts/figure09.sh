#!/usr/bin/env bash
# figure09.sh [MAP.csv [OUTPUT]]: the domain map of two stops with equal casings.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 09 ${1:+--map "$1"} ${2:+--output "$2"}
