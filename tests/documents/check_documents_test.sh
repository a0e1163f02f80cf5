#!/usr/bin/env bash
# check_documents_test.sh CHECK_DOCUMENTS: the check accepts good links and names each that leads nowhere.
set -euo pipefail
check=$1
top=$(mktemp -d)
trap 'rm -rf "$top"' EXIT
mkdir "$top/docs" "$top/results"

# expect NAME STATUS [LINE...]: runs the check; what it prints must be exactly these lines.
expect() {
  local name=$1 status=$2 actual=0 output
  shift 2
  output=$("$check" "$top" 2>&1) || actual=$?
  local expected
  expected=$(printf '%s\n' "$@")
  [[ $actual == "$status" && $output == "$expected" ]] && return
  printf '%s: status %s, expected %s\nprinted:\n%s\nexpected:\n%s\n' "$name" "$actual" "$status" "$output" "$expected"
  exit 1
}

printf '# A title\n\n[guide](docs/guide.md#the-ball-behind-floquet), [here](#a-title), [outside](https://example.org/x)\n' >"$top/README.md"
printf '# Guide\n\n## The ball behind `floquet`\n\n[back](../README.md)\n' >"$top/docs/guide.md"
printf '# Results\n' >"$top/results/README.md"
expect 'good links' 0

wide=$(printf 'x%.0s' {1..121})
printf '[file](missing.md)\n[heading](../README.md#another)\n%s\n| %s |\n' "$wide" "$wide" >>"$top/docs/guide.md"
expect 'bad links' 1 'docs/guide.md: there is no missing.md' 'docs/guide.md: there is no heading ../README.md#another' \
  'docs/guide.md:8: wider than 120 characters'

printf '# Guide\n\n## The ball behind `floquet`\n' >"$top/docs/guide.md"
words=$(printf 'a %.0s' {1..29})
method() { printf '# Method\n\n    %s\n\n%s\n' "$words and more" "$1" >"$top/docs/method.md"; }
method "Some ${words% }.
Others ${words% }.
- An ${words}item
- that ${words}ends. "
expect 'sentences of 30 words and an item of 31' 1 'docs/method.md:7: a sentence of 31 words, allowed: 30' \
  'docs/method.md:8: a sentence of 31 words, allowed: 30'
method "Some ${words% }
more.
Others ${words% }."
expect 'a sentence over two lines' 1 'docs/method.md:5: a sentence of 31 words, allowed: 30'
method "Some ${words% }."
expect 'no long sentence' 0

method 'Whatever they meet, guards hold. What do they hold? See below.

| What | is in a table |

    What is in code

<!-- Made by a program; what follows is not written by hand. -->

What a program says.

<!-- End of what is made. -->

Words by hand.'
printf '# Changes\n\nWhat a user sees.\n' >"$top/CHANGELOG.md"
expect 'questions, tables, code, generated text and changes' 0
method '<!-- Made by a program. -->
What it says.
<!-- End of what is made. -->
What a person says.'
expect 'text behind what is generated' 1 'docs/method.md:8: a sentence begins with What in place of a noun'
method '- *Guards.* Of two the first
  counts. *What* else

1. What is left.'
expect 'no nouns' 1 'docs/method.md:5: a sentence begins with Of in place of a noun' \
  'docs/method.md:5: a sentence begins with What in place of a noun' \
  'docs/method.md:8: a sentence begins with What in place of a noun'

method 'No more than this.'
mkdir -p "$top/docs/method" "$top/docs/guide/more" "$top/docs/library"
printf '# A chapter\n\n[up](../method.md#method), [guide](../guide/more/maps.md#maps)\n\nSome %s.\n' "$words and" \
  >"$top/docs/method/chapter.md"
printf '# Maps\n\n[chapter](../../method/chapter.md#a-chapters), [lost](../gone.md)\n\nSome %s.\nOf all these.\n' "$words and" \
  >"$top/docs/guide/more/maps.md"
printf '# Pages of doxygen\n\n[a header](response/settle.hpp)\n' >"$top/docs/library/main_page.md"
expect 'documents in folders' 1 'docs/guide/more/maps.md: there is no heading ../../method/chapter.md#a-chapters' \
  'docs/guide/more/maps.md: there is no ../gone.md' \
  'docs/guide/more/maps.md:5: a sentence begins with Of in place of a noun' \
  'docs/method/chapter.md:5: a sentence of 31 words, allowed: 30'
