#!/usr/bin/env bash
# figure13.sh [OUTPUT]: motions in an annulus with offset.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 13 ${1:+--output "$1"}
