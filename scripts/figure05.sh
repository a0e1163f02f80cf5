#!/usr/bin/env bash
# figure05.sh [OUTPUT]: a kick after which rub dies out.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure 05 ${1:+--output "$1"}
