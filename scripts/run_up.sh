#!/usr/bin/env bash
# run_up.sh DIR OUTPUT HEADING: the earlier name of `rubplot run-up`.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" run-up "$1" --output "$2" --heading "$3"
