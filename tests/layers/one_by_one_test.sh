#!/usr/bin/env bash
# one_by_one_test.sh TOP WORK COMPILER: builds the storeys of the repository TOP in the directory WORK, each where those
# above it are deleted; of `core` and `maps` alone also `rubsweep` and the tests of both, which are run.
set -euo pipefail
top=$1 work=$2 compiler=$3
rm -rf "$work"
mkdir -p "$work/tree"
cd "$top"
git ls-files -z --cached --others --exclude-standard | grep -zvE '^lib/rubsweep/(maps|analysis|measurement|ring)/' |
  xargs -0 cp --parents -t "$work/tree"

# build STOREY TARGET...: adds the storey to the tree and builds these.
build() {
  local storey=$1
  shift
  [[ -d $work/tree/lib/rubsweep/$storey ]] || cp -r "lib/rubsweep/$storey" "$work/tree/lib/rubsweep/"
  cmake -S "$work/tree" -B "$work/build" -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER="$compiler" \
    -D CMAKE_CXX_FLAGS_RELEASE='-O1 -DNDEBUG' -D RUBSWEEP_WERROR=ON >"$work/log" 2>&1 || { tail -n 30 "$work/log"; exit 1; }
  cmake --build "$work/build" --target "$@" >"$work/log" 2>&1 || { tail -n 30 "$work/log"; exit 1; }
}

build core rubsweep_storey_core
build maps rubsweep_storey_maps rubsweep unit_tests
for folder in analysis measurement ring; do
  [[ ! -e $work/tree/lib/rubsweep/$folder ]] || { echo "$folder is there already"; exit 1; }
done
ctest --test-dir "$work/build" --output-on-failure --parallel "$(nproc)" --no-tests=error -L unit -E '^(scripts|rubplot)[.]'
ctest --test-dir "$work/build" --output-on-failure --no-tests=error -R '^layers[.]first_map$'
build analysis rubsweep_storey_analysis
build measurement rubsweep_storey_measurement
build ring rubsweep_storey_ring
rm -rf "$work"
