#!/usr/bin/env bash
# The help of every program fits a terminal: help_width_test.sh PROGRAM..., --help with no line above 100 columns.
set -euo pipefail
export LC_ALL=C.UTF-8
(($# >= 8)) || { echo 'fewer programs than there are' >&2; exit 1; }
for program in "$@"; do
  name=${program##*/}
  text=$("$program" --help)
  while IFS= read -r line; do
    ((${#line} <= 100)) || { echo "$name --help: ${#line} columns: $line" >&2; exit 1; }
  done <<<"$text"
  # Filling lines anew keeps the parts of a text apart.
  [[ $text == *$'\n\nExit codes: 0 '* ]] || { echo "$name --help: exit codes begin no paragraph" >&2; exit 1; }
  usage=${text%%$'\n\n'*}
  [[ $usage == "$name "* && $usage == *$'\n'[A-Z]* ]] || { echo "$name --help: usage and purpose are one line" >&2; exit 1; }
done
