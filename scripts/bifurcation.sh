#!/usr/bin/env bash
# bifurcation.sh DIR OUTPUT HEADING: the earlier name of `rubplot line`.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" line "$1" --output "$2" --heading "$3"
