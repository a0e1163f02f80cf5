#!/usr/bin/env bash
# Values that rubplot reads from a printed configuration are those of the program: every value that it finds, given
# back by --set, leaves the configuration as it is, and each is found at its place.
source "$(dirname "$0")/support.sh"

# values FILE: lines PATH=VALUE.
values() {
  PYTHONPATH=$top/scripts python3 -B -c 'import sys
from rubplot import configuration
for path, value in configuration.read_configuration(sys.argv[1]).items(): print(f"{path}={value}")' "$1"
}

for stem in minimal benchmark/both_sides_unequal benchmark/annulus_offset rotor_kit; do
  expect_exit 0 "$top/configs/$stem.yaml" --print-config
  cp stdout printed.yaml
  values printed.yaml >values
  # Every line of the file that holds a value is one of them.
  [[ $(wc -l <values) == "$(grep -cE ': ?[^ ]' printed.yaml)" ]] || fail "$stem: other values than the file has"
  arguments=()
  while IFS= read -r value; do arguments+=(--set "$value"); done <values
  expect_exit 0 printed.yaml "${arguments[@]}" --print-config
  expect_same stdout printed.yaml
  # The last number of the file, changed at its place, is found there.
  expect_exit 0 printed.yaml --set response.max_order=7 --set stops.0.clearance_m=0.00123 --print-config
  values stdout >changed
  diff <(grep -vxF -f values changed) - <<<$'stops.0.clearance_m=0.00123\nresponse.max_order=7' || fail "$stem: other values changed"
done
