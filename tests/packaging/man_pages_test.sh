#!/usr/bin/env bash
# man_pages_test.sh MAN1 PROGRAM...: groff has nothing to complain of in the page of any program, and each shows every option
# of its help, and every exit code. 77: there is no man.
set -euo pipefail
export LC_ALL=C.UTF-8
man1=$1
shift
command -v man >/dev/null && command -v groff >/dev/null || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "$1" >&2
  exit 1
}

for program; do
  name=${program##*/}
  page=$man1/$name.1.gz
  [[ -s $page ]] || fail "there is no $page"
  MANROFFSEQ='' MANWIDTH=90 man --warnings -E UTF-8 -l -Tutf8 "$page" >"$work/$name" 2>"$work/warnings"
  [[ ! -s $work/warnings ]] || fail "$name.1: $(<"$work/warnings")"
  sed -i -E $'s/.\b//g; s/\e\\[[0-9;]*m//g' "$work/$name"
  "$program" --help >"$work/help"
  for part in NAME SYNOPSIS DESCRIPTION 'SEE ALSO'; do
    grep -qx "$part" "$work/$name" || fail "$name.1 has no part $part"
  done
  grep -qE "^ *$name +. +[A-Z]" "$work/$name" || fail "$name.1 does not say what it is of"
  count=0
  while read -r option; do
    grep -qE -e "^ +(-. [^ ]+, )?$option( |\$)" "$work/$name" || fail "$name.1 says nothing of $option"
    count=$((count + 1))
  done < <(grep -oE '^  --[a-z-]+' "$work/help")
  [[ $name == rubplot ]] || ((count >= 5)) || fail "$name --help: $count options"
done
