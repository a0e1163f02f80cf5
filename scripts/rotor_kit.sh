#!/usr/bin/env bash
# rotor_kit.sh [DIR]: the experiment on a rotor kit by simulation: its reports in DIR (results/rotor_kit) and three pictures.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure rotor-kit ${1:+--map "$1"}
