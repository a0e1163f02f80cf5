#!/usr/bin/env bash
# basin_figure.sh DIR OUTPUT HEADING: the earlier name of `rubplot basin`.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" basin "$1" --output "$2" --heading "$3"
