#!/usr/bin/env bash
# shells_test.sh COMPLETION PROGRAM...: every option of a program's help is offered by bash, zsh and fish, by those of
# them that there are; words that an option chooses from; files of the kind that the program reads; pictures of rubplot.
set -euo pipefail
export LC_ALL=C.UTF-8
completion=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/folder"
touch "$work/my.yaml" "$work/map.csv" "$work/other.txt"
cd "$work"

fail() {
  echo "$1" >&2
  exit 1
}

# offered_by_SHELL LINE: what stands behind the line's last word, a candidate per line.
offered_by_bash() {
  COMPLETED=$1 bash -c '
    source "$0/bash/rubsweep"
    compopt() { :; }  # there is no completion under way
    read -ra COMP_WORDS <<<"$COMPLETED"
    [[ $COMPLETED != *" " ]] || COMP_WORDS+=("")
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
    _rubsweep "${COMP_WORDS[0]}" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
    printf "%s\n" "${COMPREPLY[@]}"' "$completion"
}
offered_by_fish() {
  fish --no-config -c "source $completion/fish/${1%% *}.fish; complete -C '$1'" | cut -f1
}
offered_by_zsh() {
  local candidate
  printf '%s\n' "$1" >&"$to_zsh"
  while IFS= read -r candidate <&"$from_zsh" && [[ -n $candidate ]]; do printf '%s\n' "$candidate"; done
}

# expect SHELL LINE CANDIDATE...
expect() {
  local shell=$1 line=$2 offered candidate
  shift 2
  "offered_by_$shell" "$line" | sed 's,/$,,' >"$work/.offered"
  offered=$(<"$work/.offered")
  for candidate; do
    grep -qxF -e "$candidate" <<<"$offered" || fail "$shell: '$line' is not completed to '$candidate' but to: $offered"
  done
}

# refuse SHELL LINE CANDIDATE
refuse() {
  ! "offered_by_$1" "$2" | grep -qxF -e "$3" || fail "$1: '$2' is completed to '$3'"
}

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
PATH=$(dirname "$1"):$PATH
tried=0
for shell in bash zsh fish; do
  command -v "$shell" >/dev/null || continue
  tried=$((tried + 1))
  if [[ $shell == zsh ]]; then
    coproc zsh { python3 -B "$here/zsh_completion.py" "$completion/zsh"; }
    exec {to_zsh}>&"${zsh[1]}" {from_zsh}<&"${zsh[0]}"  # for subshells, too
  fi
  for program; do
    name=${program##*/}
    [[ $name != rubplot ]] || continue
    mapfile -t options < <("$program" --help | sed -nE 's/^  (--[a-z-]+) .*/\1/p')
    ((${#options[@]} >= 5)) || fail "$name: ${#options[@]} options"
    expect "$shell" "$name --" "${options[@]}"
  done
  expect "$shell" 'rubsweep --progress ' auto always never
  expect "$shell" 'rubsweep --init ' one_side both_sides annular rotor_kit ross
  expect "$shell" 'rubsweep --set stops.0.cl' stops.0.clearance_m=
  expect "$shell" 'rubbranch --along kick.f' kick.force_n
  expect "$shell" 'ringstab --set loads.0.a' loads.0.angle_deg=
  expect "$shell" 'rubsweep my' my.yaml
  refuse "$shell" 'rubsweep ' other.txt
  expect "$shell" 'rubsweep-compare ma' map.csv
  expect "$shell" 'rubscope ma' map.csv
  expect "$shell" 'rubsweep --status fo' folder
  refuse "$shell" 'rubsweep --status ' my.yaml
  expect "$shell" 'rubplot ma' map
  expect "$shell" 'rubplot map --fa' --fade
  refuse "$shell" 'rubplot trace --fa' --fade
done
echo "shells: $tried"
