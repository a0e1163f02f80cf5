#!/usr/bin/env bash
# figure07.sh [OUTPUT]: subharmonic motions 1/2 to 1/5 against one stop, set A.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 07 ${1:+--output "$1"}
