#!/usr/bin/env bash
# pre_commit.sh: formats the C++ files of a commit by .clang-format, as a hook of git:
#   ln -s ../../scripts/pre_commit.sh .git/hooks/pre-commit
# A file of which the commit takes a part alone is not touched; the commit ends, and the file is named.
set -euo pipefail
cd "$(git rev-parse --show-toplevel)"
command -v clang-format >/dev/null || { echo 'pre_commit.sh: no clang-format; scripts/bootstrap.sh clang-format' >&2; exit 1; }

mapfile -d '' -t files < <(git diff --cached --name-only --diff-filter=d -z -- '*.cpp' '*.hpp')
in_parts=0
for file in "${files[@]}"; do
  if git show ":$file" | clang-format --assume-filename="$file" | cmp -s - <(git show ":$file"); then
    continue
  fi
  if git diff --quiet -- "$file"; then
    clang-format -i "$file"
    git add -- "$file"
  else
    echo "pre_commit.sh: $file is not formatted, and only a part of it is in the commit" >&2
    in_parts=1
  fi
done
exit "$in_parts"
