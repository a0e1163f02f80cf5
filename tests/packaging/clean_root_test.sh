#!/usr/bin/env bash
# clean_root_test.sh BUILD: installs the package of BUILD in a Debian 12 root that mmdebstrap makes, computes a first
# map there with figure and report, purges the package without a trace, and builds a program with the other package.
# What somebody sees in his first ten minutes is then in BUILD/transcript.txt, the installed files with their sizes in
# BUILD/installed_files.txt. Minutes, and Debian's packages by network. 77: there is no mmdebstrap.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$1
command -v mmdebstrap >/dev/null || exit 77
export LC_ALL=C.UTF-8

(cd "$build" && cpack -G DEB >cpack.log 2>&1) || { cat "$build/cpack.log"; exit 1; }
packages=("$build"/rubsweep_*_*.deb)
for_developers=("$build"/rubsweep-dev_*_*.deb)
((${#packages[@]} == 1 && ${#for_developers[@]} == 1)) ||
  { echo "more than one package: ${packages[*]} ${for_developers[*]}"; exit 1; }
if command -v lintian >/dev/null; then
  lintian --fail-on error "${packages[0]}" "${for_developers[0]}"
fi

# The root is in the first argument of a hook, with /proc and the like, and gone behind the last one.
copied=("${packages[0]}" "${for_developers[0]}")
for script in first_map.sh first_ten_minutes.sh terminal_session.py installed_and_purged.sh developed.sh; do
  copied+=("$here/$script")
done
mmdebstrap --quiet --variant=minbase --format=null \
  --customize-hook="copy-in$(printf " '%s'" "${copied[@]}") /tmp" \
  --customize-hook="chroot \"\$1\" sh /tmp/installed_and_purged.sh /tmp/$(basename "${packages[0]}")" \
  --customize-hook="copy-out /tmp/transcript.txt /tmp/installed_files.txt '$build'" \
  --customize-hook="chroot \"\$1\" sh /tmp/developed.sh /tmp/$(basename "${for_developers[0]}")" \
  bookworm /dev/null
cat "$build/transcript.txt"
