#!/usr/bin/env bash
# figure11.sh [MAP.csv [OUTPUT]]: the domain map of the centred annulus.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 11 ${1:+--map "$1"} ${2:+--output "$2"}
