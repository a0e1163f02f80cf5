#!/usr/bin/env bash
# cascade.sh DIR OUTPUT HEADING: the earlier name of `rubplot cascade`.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" cascade "$1" --output "$2" --heading "$3"
