#!/usr/bin/env bash
# figure08.sh [OUTPUT]: synchronous, 1/3 and 1/5 motions between two stops.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 08 ${1:+--output "$1"}
