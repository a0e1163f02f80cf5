#!/usr/bin/env bash
# check_documents.sh [TOP]: every relative link of the documents in TOP names a file that is there and, behind a #, a heading
# of it; no line but those of tables and links is wider than 120 characters. Lists what is not so; exits 1 if there is any.
set -euo pipefail
export LC_ALL=C.UTF-8
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}"

broken=0
complain() {
  echo "$1: $2"
  broken=1
}

# anchors FILE: the names by which its headings can be linked to.
anchors() {
  sed -nE 's/^#+ +//p' "$1" | tr '[:upper:]' '[:lower:]' | sed -E 's/[^[:alnum:] _-]//g; s/ /-/g'
}

check_link() {
  local file=$1 link=$2 path=${2%%#*} target
  target=$file
  [[ -z $path ]] || target=$(dirname "$file")/$path
  if [[ ! -e $target ]]; then
    complain "$file" "there is no $link"
  elif [[ $link == *'#'* ]] && ! anchors "$target" | grep -qxF -- "${link#*#}"; then
    complain "$file" "there is no heading $link"
  fi
}

for file in *.md docs/*.md results/*.md; do
  while IFS= read -r link; do
    [[ $link == *://* ]] || check_link "$file" "$link"
  done < <(grep -oE '\]\([^) ]+\)' "$file" | sed -E 's/^\]\(|\)$//g')
  while IFS= read -r line; do
    complain "$file:$line" 'wider than 120 characters'
  done < <(awk 'length > 120 && !/^\|/ { print FNR }' "$file")
done

exit "$broken"
