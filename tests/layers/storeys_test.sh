#!/usr/bin/env bash
# storeys_test.sh LIB COMPILER [INCLUDE_DIRECTORY...]: every header and source of each storey of LIB/rubsweep finds all that
# it includes where there is nothing but the storey itself and those that it stands on.
set -euo pipefail
lib=$1 compiler=$2
shift 2
outside=()
for directory; do outside+=(-isystem "$directory"); done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# check STOREY BELOW...: the compiler reads all files of the storey at once, and looks no further than their includes.
broken=0
check() {
  local storey=$1 tree=$work/$1/rubsweep
  [[ -d $lib/rubsweep/$storey ]] || return 0
  mkdir -p "$tree"
  for name; do ln -s "$(realpath "$lib")/rubsweep/$name" "$tree/$name"; done
  (cd "$work/$storey" && find -L "rubsweep/$storey" -name '*.hpp' -o -name '*.cpp' | sort |
    sed 's/.*/#include "&"/') >"$work/$storey.cpp"
  (($(wc -l <"$work/$storey.cpp") > 8)) || { echo "$storey: hardly any files"; broken=1; }
  "$compiler" -std=c++20 -DRUBSWEEP_VERSION='""' -DRUBSWEEP_HDF5_LIBRARY='""' -M -MF /dev/null -I "$work/$storey" \
    "${outside[@]}" "$work/$storey.cpp" 2>"$work/problems" || { grep -E 'error' "$work/problems" | head -n 20; broken=1; }
}

check core
check maps core
check analysis maps core
check measurement analysis maps core
check ring maps core

# A storey that does include what is above it is found out.
echo '#include "rubsweep/maps/sweep/row.hpp"' >"$work/wrong.cpp"
! "$compiler" -std=c++20 -M -MF /dev/null -I "$work/core" "$work/wrong.cpp" 2>/dev/null || { echo 'not found out'; broken=1; }
exit "$broken"
