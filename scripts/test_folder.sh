#!/usr/bin/env bash
# test_folder.sh FOLDER...: builds the tests of folders of the library, and of those below them, in the preset dev (each
# source alone, with little optimisation), and runs them. A folder is named as below lib/rubsweep or tests: contact,
# integrate/exact, tests/maps/config/yaml. Everything else of the build stays as it is.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/dev

case ${1-} in
  '' | -h | --help) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
[[ -e $build/build.ninja ]] || cmake --preset dev
mapfile -t programs < <(ninja -C "$build" -t query tests/unit_tests | grep -oE '[a-z_]+_test$' | sort -u)

targets=() labels=
for folder in "$@"; do
  folder=${folder%/} folder=${folder#lib/rubsweep/} folder=${folder#tests/}
  stem=${folder#core/} stem=${stem#maps/} stem=${stem#analysis/} stem=${stem#measurement/}
  mapfile -t own < <(printf '%s\n' "${programs[@]}" | grep -E "^${stem//\//_}_(.+_)?test$")
  ((${#own[@]})) || { echo "test_folder.sh: there are no tests of the folder $folder" >&2; exit 2; }
  targets+=("${own[@]}")
  labels+="|(^|/)$stem(/|\$)"
done
cmake --build --preset dev --target "${targets[@]}"
ctest --preset dev -L "${labels#|}" --parallel "$(nproc)"
