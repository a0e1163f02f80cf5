#!/usr/bin/env bash
# ring_figure.sh [FIGURE [OUTPUT]]: one published ring figure (03-07, 09-21), or all of them.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure "ring${1:+-$1}" ${2:+--output "$2"}
