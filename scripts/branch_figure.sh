#!/usr/bin/env bash
# branch_figure.sh DIR OUTPUT HEADING: the earlier name of `rubplot branch`.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" branch "$1" --output "$2" --heading "$3"
