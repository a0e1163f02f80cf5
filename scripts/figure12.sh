#!/usr/bin/env bash
# figure12.sh [MAP.csv [OUTPUT]]: the domain map of the annulus with offset.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 12 ${1:+--map "$1"} ${2:+--output "$2"}
