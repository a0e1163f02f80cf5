#!/usr/bin/env bash
# compile_alone.sh [--minutes N] [FOLDER...]: reads every source of these folders, or of those that the last commit changes,
# by the compiler and without precompiled headers, so that a file that lacks an include of its own, or hides a name, shows.
# Makes no object. --minutes N: begins no file after N minutes, and counts what was left out. Exits 1 when there is an error.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
database=build/tidy

minutes=1000 folders=()
while (($#)); do
  case $1 in
    --minutes) minutes=${2:?--minutes needs a number}; shift 2 ;;
    -h | --help) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
    -*) echo "compile_alone.sh: $1 is no option, allowed: --minutes N" >&2; exit 2 ;;
    *) folders+=("${1%/}"); shift ;;
  esac
done
if ((${#folders[@]} == 0)); then
  mapfile -t folders < <(git diff --name-only --diff-filter=d HEAD^ HEAD -- '*.cpp' '*.hpp' | sed 's|/[^/]*$||' | sort -u)
fi
((${#folders[@]})) || exit 0

# The database of clang-tidy: every source as it stands.
cmake --preset release -B "$database" -DRUBSWEEP_PCH=OFF -DRUBSWEEP_UNITY=OFF >/dev/null
cmake --build "$database" --target rubsweep_commit >/dev/null
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=scripts
exec python3 scripts/analysis/compile_alone.py "$database" "$minutes" "${folders[@]}"
