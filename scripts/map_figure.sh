#!/usr/bin/env bash
# map_figure.sh [--fade] NAME FIGURE HEADING MAP.csv OUTPUT: the earlier name of `rubplot map`.
fade=()
[[ $1 != --fade ]] || { fade=(--fade) && shift; }
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" map "$4" --output "$5" --heading "$3" "${fade[@]}"
