#!/usr/bin/env bash
# Every shipped configuration of rubsweep is accepted, and so is what --print-config makes of it.
source "$(dirname "$0")/support.sh"

shopt -s nullglob
configs=()
# stop.yaml of a folder is what the stops of the others share, and no configuration of its own.
for config in "$top"/configs/*.yaml "$top"/configs/{init,reference,benchmark,hard_case,light_casing,contact_laws}/*.yaml; do
  [[ ${config##*/} == stop.yaml ]] || configs+=("$config")
done
((${#configs[@]})) || fail "there is no configuration in $top/configs"

for config in "${configs[@]}"; do
  [[ $(head -c 2 "$config") == '# ' ]] || fail "$config does not begin with its purpose"
  expect_matches "$config" '^# Run time: '

  expect_exit 0 "$config" --check
  expect_matches stdout "^$config: ok, [1-9][0-9]* cells$"
  checked=$(<stdout)

  expect_exit 0 "$config" --print-config
  cp stdout printed.yaml
  expect_exit 0 printed.yaml --print-config
  expect_same stdout printed.yaml
  expect_exit 0 printed.yaml --check
  [[ $(<stdout) == "${checked/#"$config"/printed.yaml}" ]] || fail "printed.yaml has another number of cells"

  expect_exit 0 "$config" --explain
  expect_matches stdout '^rotor: '
  expect_matches stdout '^sweep: [1-9][0-9]* cells'
  expect_empty stderr
  cp stdout explained
  expect_exit 0 printed.yaml --explain
  expect_same stdout explained
done

# Asking runs nothing.
expect_files . explained printed.yaml stderr stdout
