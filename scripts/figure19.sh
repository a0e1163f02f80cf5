#!/usr/bin/env bash
# figure19.sh [OUTPUT]: the rotor kit at 70 rev/s, as figures 15 to 17 and 19 to 21 have it.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 19 ${1:+--output "$1"}
