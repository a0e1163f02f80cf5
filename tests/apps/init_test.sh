#!/usr/bin/env bash
# Configurations to begin with: each is printed whole, is accepted without a question, and makes a map with and without rub.
source "$(dirname "$0")/support.sh"

cp "$top/configs/init/rotor.toml" .  # what the template ross names
for kind in one_side both_sides annular rotor_kit ross; do
  expect_exit 0 --init "$kind"
  expect_empty stderr
  cp stdout my.yaml
  [[ $(head -n 1 my.yaml) == '# yaml-language-server: $schema=rubsweep.schema.json' ]] || fail "$kind: names another schema"
  # Nothing but that line differs from the file that is shipped.
  tail -n +3 my.yaml >printed
  tail -n +2 "$top/configs/init/$kind.yaml" >shipped
  expect_same printed shipped
  expect_exit 0 my.yaml --check
  expect_matches stdout '^my\.yaml: ok, [1-9][0-9]* cells$'
  expect_empty stderr

  # Every third line with numbers says where they come from, at least: segments and second stops repeat what was said.
  numbers=$(grep -cE '^[^#]*[0-9]' my.yaml)
  said=$(grep -cE '^[^#]*[0-9].* # ' my.yaml)
  ((3 * said >= numbers)) || fail "$kind: $said comments on $numbers lines with numbers"

  expect_exit 0 my.yaml --set sweep.speed_rpm.count=5 --output "$kind" --quiet
  rubbing=$(grep -vc -e '^#' -e '^speed_hz' -e ',non_contact,' "$kind/map.csv") || true
  quiet=$(grep -c ',non_contact,' "$kind/map.csv") || true
  ((rubbing >= 2 && quiet >= 1)) || fail "$kind: $rubbing cells rub, $quiet do not"
  if grep -E ',(failed|initial_contact),' "$kind/map.csv"; then fail "$kind: cells that are no motion"; fi
done

expect_usage_error "--init: 'one_sid' is unknown (did you mean 'one_side'?), allowed: one_side, both_sides, annular" --init one_sid
expect_usage_error "the required argument for option '--init' is missing" --init
expect_usage_error '--init: is asked for alone, allowed: without CONFIG.yaml' "$minimal" --init ross
