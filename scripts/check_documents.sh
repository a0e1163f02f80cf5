#!/usr/bin/env bash
# check_documents.sh [TOP]: every relative link of the documents in TOP names a file that is there and, behind a #, a heading
# of it; no line but those of tables and links is wider than 120 characters; no sentence of the method (docs/method.md and
# docs/method) has more than 30 words; no sentence but those of the changes begins with Of, What or Those in place of a noun. Lists what is not so; exits 1
# if there is any.
set -euo pipefail
shopt -s globstar nullglob
export LC_ALL=C.UTF-8
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}"

broken=0
complain() {
  echo "$1: $2"
  broken=1
}

# read_anchors FILE: into `anchors`, the names by which its headings can be linked to, each in a line.
declare -A anchors=()
read_anchors() {
  [[ -v "anchors[$1]" ]] ||
    anchors[$1]=$'\n'$(sed -nE 's/^#+ +//p' "$1" | tr '[:upper:]' '[:lower:]' | sed -E 's/[^[:alnum:] _-]//g; s/ /-/g')$'\n'
}

check_link() {
  local file=$1 link=$2 path=${2%%#*} folder=. target
  [[ $file != */* ]] || folder=${file%/*}
  target=$file
  [[ -z $path ]] || target=$folder/$path
  if [[ ! -e $target ]]; then
    complain "$file" "there is no $link"
  elif [[ $link == *'#'* ]]; then
    read_anchors "$target"
    [[ ${anchors[$target]} == *$'\n'"${link#*#}"$'\n'* ]] || complain "$file" "there is no heading $link"
  fi
}

# sentences FILE: line of its paragraph, number of words and first word of every sentence that has more than 30 of them or, if
# it is no question, begins with Of, What or Those. Code, tables, headings and generated parts are none, an item of a list
# ends at the next. A formula counts its terms that have a letter or a digit.
sentences() {
  awk '
    function finish(   i, n, words, word, first) {
      n = split(paragraph, words, " ")
      for (i = 1; i <= n; ++i) {
        if (first == "" && words[i] ~ /[[:alpha:]]/) first = words[i]
        if (words[i] ~ /[[:alnum:]]/) ++word
        if (i < n && !(words[i] ~ /[.?!][])"*`]*$/ && words[i + 1] ~ /^[[:upper:]`*"([]/)) continue
        gsub(/[*_(]/, "", first)
        nounless = first ~ /^(Of|What|Those)$/ && words[i] !~ /[?]/
        if (word > 30 || nounless) print start, word, nounless ? first : ""
        word = 0
        first = ""
      }
      paragraph = ""
    }
    /^<!-- Made by/ { made = 1 }
    /^<!-- End of what is made/ { made = 0; next }
    made { finish(); next }
    /^(    |[|#!]|[[:space:]]*$)/ { finish(); next }
    /^ *([-*]|[0-9]+\.) / { finish() }
    { if (paragraph == "") start = FNR; paragraph = paragraph " " $0 }
    END { finish() }' "$1"
}

for file in *.md docs/**/*.md results/*.md; do
  [[ $file != docs/library/* ]] || continue  # pages of doxygen, which has its own links
  while IFS= read -r link; do
    [[ $link == *://* ]] || check_link "$file" "$link"
  done < <(grep -oE '\]\([^) ]+\)' "$file" | sed -E 's/^\]\(|\)$//g' | awk '!seen[$0]++')
  while IFS= read -r line; do
    complain "$file:$line" 'wider than 120 characters'
  done < <(awk 'length > 120 && !/^\|/ { print FNR }' "$file")
  [[ $file != CHANGELOG.md ]] || continue
  while read -r line words first; do
    [[ $file != docs/method.md && $file != docs/method/* ]] || ((words <= 30)) || complain "$file:$line" "a sentence of $words words, allowed: 30"
    [[ -z $first ]] || complain "$file:$line" "a sentence begins with $first in place of a noun"
  done < <(sentences "$file")
done

exit "$broken"
