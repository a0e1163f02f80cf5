#!/usr/bin/env bash
# figure07.sh [OUTPUT]: subharmonic motions against one stop.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 07 ${1:+--output "$1"}
