#!/usr/bin/env bash
# trace.sh DIR OUTPUT HEADING [REVOLUTIONS [DIR]...]: the earlier name of `rubplot trace`.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" trace "$1" "${@:5}" --output "$2" --heading "$3" --revolutions "${4:-40}"
