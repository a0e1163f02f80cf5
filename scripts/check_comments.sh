#!/usr/bin/env bash
# check_comments.sh [TOP]: no comment in the sources of TOP begins with Of, What, That or Those in place of a noun, nor does
# a paragraph of one or a docstring. Lists each that does as file:line; exits 1 if there is any.
set -euo pipefail
export LC_ALL=C.UTF-8
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}"

folders=()
for folder in apps configs examples lib packaging scripts studies tests; do [[ ! -d $folder ]] || folders+=("$folder"); done
((${#folders[@]})) || { echo "no sources in $PWD"; exit 1; }

find "${folders[@]}" -type f -regex '.*\.\(cpp\|hpp\|js\|css\|sh\|py\|gp\|cmake\|yaml\)\|.*/CMakeLists\.txt' -print0 |
  sort -z | xargs -0 awk '
    FNR == 1 { inside = 0 }
    {
      comment = /^[ \t]*(\/\/+|#) /
      docstring = FILENAME ~ /\.py$/ && /^[ \t]*"""(Of|What|That|Those) /
      if (docstring || comment && !inside && /^[ \t]*(\/\/+|#) (Of|What|That|Those) /) {
        sub(/^[ \t]+/, "")
        print FILENAME ":" FNR ": begins without a noun: " $0
        found = 1
      }
      inside = comment
    }
    END { exit found }' || exit 1
