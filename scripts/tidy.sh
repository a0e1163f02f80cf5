#!/usr/bin/env bash
# tidy.sh [--minutes N] [--all | BASE]: clang-tidy, as .clang-tidy has it, on the C++ files that differ from the commit BASE;
# with --all on every source but those of examples/, which are built elsewhere. Without either, BASE is where this branch
# left main (on main itself: the commit before). A header is looked at through a source that includes it. --minutes N: begins
# no file after N minutes and names those that were left out. Exits 1 when there is a finding.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
database=build/tidy

minutes=1000 all=false base=
while (($#)); do
  case $1 in
    --minutes) minutes=${2:?--minutes needs a number}; shift 2 ;;
    --all) all=true; shift ;;
    -h | --help) sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
    -*) echo "tidy.sh: $1 is no option, allowed: --all, --minutes N" >&2; exit 2 ;;
    *) base=$1; shift ;;
  esac
done

default_base() {
  local main
  for main in main origin/main; do
    git rev-parse -q --verify "$main^{commit}" >/dev/null || continue
    base=$(git merge-base HEAD "$main") || continue
    [[ $base != "$(git rev-parse HEAD)" ]] || base=$(git rev-parse -q --verify HEAD^) || base=HEAD
    return
  done
  echo "tidy.sh: there is no branch main to compare with, name a commit or --all" >&2
  exit 2
}

# includers FILE PATTERN: files of this PATTERN that include FILE.
includers() {
  # Folders from which files are included by name.
  local name=${1#lib/}
  name=${name#tests/} name=${name#apps/}
  git grep -lF "#include \"$name\"" -- "$2" || true
  # The parts of a program include each other by the name alone.
  [[ $1 != apps/* ]] || git grep -lF "#include \"${1##*/}\"" -- "${1%/*}/$2" || true
}

# source_of FILE: the source through which clang-tidy sees it: itself, that of the same name, one that includes it, or one
# through which a header is seen that includes it. Nothing for a header that nobody includes.
source_of() {
  local header source
  if [[ $1 == *.cpp ]]; then
    source=$1
  elif [[ -e ${1%.hpp}.cpp ]]; then
    source=${1%.hpp}.cpp
  else
    source=$(includers "$1" '*.cpp' | head -n 1)
    for header in $(includers "$1" '*.hpp'); do
      [[ -z $source ]] || break
      source=$(source_of "$header")
    done
  fi
  echo "$source"
}

if $all; then
  mapfile -t sources < <(git ls-files '*.cpp' ':!examples')
else
  [[ $base ]] || default_base
  mapfile -t sources < <(git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.hpp' ':!examples' |
    while IFS= read -r file; do source_of "$file"; done | sort -u | sed '/^$/d')
fi
((${#sources[@]})) || exit 0

scripts/bootstrap.sh clang-tidy
# clang-tidy sees every file as it stands.
cmake --preset release -B "$database" -DRUBSWEEP_PCH=OFF -DRUBSWEEP_UNITY=OFF >/dev/null
cmake --build "$database" --target rubsweep_commit >/dev/null

# check DEADLINE FILE
check() {
  if ((EPOCHSECONDS >= $1)); then
    echo "$2: left out, the time is up"
    return
  fi
  local findings
  findings=$(clang-tidy --quiet -p "$database" "$2" 2>/dev/null) && return
  printf '%s\n' "${findings:-$2: clang-tidy cannot read it, see clang-tidy -p build/tidy $2}"
  return 1
}
export -f check
export database
printf '%s\0' "${sources[@]}" |
  xargs -0 -n 1 -P "$(nproc)" bash -c 'check "$@"' check "$((EPOCHSECONDS + 60 * minutes))" || exit 1
echo "clang-tidy: nothing found"
