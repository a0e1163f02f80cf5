#!/usr/bin/env bash
# check_layers_test.sh CHECK_LAYERS: the check accepts a clean tree and names each include that breaks a rule.
set -euo pipefail
check=$1
lib=$(mktemp -d)
trap 'rm -rf "$lib"' EXIT

# source_file FILE LINE...: writes lib/rubsweep/FILE.
source_file() {
  local file=$lib/rubsweep/$1
  shift
  mkdir -p "$(dirname "$file")"
  printf '%s\n' "$@" >"$file"
}

# expect NAME STATUS [LINE...]: runs the check; what it prints must be exactly these lines.
expect() {
  local name=$1 status=$2 actual=0 output
  shift 2
  output=$("$check" "$lib" 2>&1) || actual=$?
  output=${output//"$lib"\//}
  if [[ $actual != "$status" || $output != "$(printf '%s\n' "$@")" ]]; then
    printf '%s: status %s, wanted %s, output:\n%s\nwanted:\n' "$name" "$actual" "$status" "$output"
    printf '%s\n' "$@"
    exit 1
  fi
}

expect 'nothing to check' 1 'no directory rubsweep'

source_file core/error.hpp '#include <stdexcept>'
source_file core/model/machine.hpp '#include "rubsweep/core/error.hpp"'
source_file core/scene/scene.cpp '#include "rubsweep/core/model/machine.hpp"' \
  '#include <vector>  // not "rubsweep/maps/report/map.hpp"'
source_file maps/config/yaml/reader.cpp '  #  include <yaml-cpp/yaml.h>' '#include "rubsweep/core/model/machine.hpp"'
source_file ring/ring.hpp '#include "rubsweep/core/error.hpp"'
expect 'clean tree, also over two layers' 0

source_file core/model/range.hpp '#pragma once' '' '#include "rubsweep/core/scene/scene.cpp"'
expect 'upwards' 1 'rubsweep/core/model/range.hpp:3: model may not include rubsweep/core/scene/scene.cpp'
source_file core/model/range.hpp '#include <rubsweep/core/scene/scene.cpp>'
expect 'upwards with angle brackets' 1 \
  'rubsweep/core/model/range.hpp:1: model may not include rubsweep/core/scene/scene.cpp'
source_file core/model/range.hpp '#include "rubsweep/core/model/gone.hpp"'
expect 'absent file' 1 "rubsweep/core/model/range.hpp:1: there is no rubsweep/core/model/gone.hpp under $lib"
source_file core/model/range.hpp '#include <yaml-cpp/yaml.h>'
expect 'YAML outside config' 1 'rubsweep/core/model/range.hpp:1: only config/yaml/ may include yaml-cpp/yaml.h'
source_file core/model/range.hpp '#include "rubsweep/maps/config/yaml/reader.cpp"'
expect 'a storey upwards' 1 'rubsweep/core/model/range.hpp:1: core does not stand on rubsweep/maps/config/yaml/reader.cpp'
source_file core/model/range.hpp ''
source_file maps/config/yaml/reader.cpp '#include "rubsweep/ring/ring.hpp"'
expect 'a storey beside' 1 'rubsweep/maps/config/yaml/reader.cpp:1: maps does not stand on rubsweep/ring/ring.hpp'
source_file maps/config/yaml/reader.cpp ''
source_file core/attic/old.hpp ''
source_file cellar/old.hpp ''
expect 'unknown folder and storey' 1 'rubsweep/cellar/old.hpp: cellar is no storey' \
  'rubsweep/core/attic/old.hpp: folder attic has no place in the layers'
