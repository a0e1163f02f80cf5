#!/usr/bin/env bash
# figure04.sh [OUTPUT]: a kick after which rub persists.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 04 ${1:+--output "$1"}
