#!/usr/bin/env bash
# figure10.sh [OUTPUT]: circle and oval in a centred annulus.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 10 ${1:+--output "$1"}
