#!/usr/bin/env bash
# check_comments_test.sh CHECK_COMMENTS: the check accepts comments that name their noun and lists each that does not.
set -euo pipefail
check=$1
top=$(mktemp -d)
trap 'rm -rf "$top"' EXIT

# expect NAME STATUS [LINE...]: runs the check; what it prints must be exactly these lines.
expect() {
  local name=$1 status=$2 actual=0 output
  shift 2
  output=$("$check" "$top" 2>&1) || actual=$?
  [[ $actual == "$status" && $output == "$(printf '%s\n' "$@")" ]] && return
  printf '%s: status %s, expected %s\nprinted:\n%s\nexpected:\n' "$name" "$actual" "$status" "$output"
  printf '%s\n' "$@"
  exit 1
}

expect 'nothing to check' 1 "no sources in $top"

mkdir -p "$top/lib/rubsweep" "$top/scripts"
printf '%s\n' '/// Norm of the state, whose square is a sum.' '/// Of two equal ones the first.' 'double norm();' \
  'int n = 0;  // Of trailing comments none is read.' >"$top/lib/rubsweep/norm.hpp"
printf '%s\n' '#!/usr/bin/env bash' '# Whatever is left.' 'echo' >"$top/scripts/left.sh"
expect 'nouns' 0

printf '%s\n' '// Those that stick.' '' '/// Norms.' '///' '/// What else there is.' '  /// That state.' 'int i;' '  /// Of a turn.' \
  >"$top/lib/rubsweep/norm.cpp"
printf '%s\n' 'echo' '# What is left.' >"$top/scripts/left.sh"
printf '%s\n' 'def norm():' '    """Norm of the state."""' 'def left():' '    """What is left."""' >"$top/scripts/norm.py"
expect 'no nouns' 1 'lib/rubsweep/norm.cpp:1: begins without a noun: // Those that stick.' \
  'lib/rubsweep/norm.cpp:5: begins without a noun: /// What else there is.' \
  'lib/rubsweep/norm.cpp:8: begins without a noun: /// Of a turn.' \
  'scripts/left.sh:2: begins without a noun: # What is left.' \
  'scripts/norm.py:4: begins without a noun: """What is left."""'
