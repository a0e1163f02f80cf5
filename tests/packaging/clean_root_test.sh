#!/usr/bin/env bash
# clean_root_test.sh BUILD: installs the package of BUILD in a Debian 12 root that mmdebstrap makes, computes a first
# map there with figure and report, and purges the package without a trace. Minutes, and Debian's packages by network.
# 77: there is no mmdebstrap.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$1
command -v mmdebstrap >/dev/null || exit 77
export LC_ALL=C.UTF-8

(cd "$build" && cpack -G DEB >cpack.log 2>&1) || { cat "$build/cpack.log"; exit 1; }
packages=("$build"/rubsweep_*_*.deb)
((${#packages[@]} == 1)) || { echo "more than one package: ${packages[*]}"; exit 1; }
if command -v lintian >/dev/null; then
  lintian --fail-on error "$build"/rubsweep_*_*.deb "$build"/rubsweep-dev_*_*.deb
fi

# The root is in the first argument of a hook, with /proc and the like, and gone behind the last one.
mmdebstrap --quiet --variant=minbase --format=null \
  --customize-hook="copy-in '${packages[0]}' '$here/first_map.sh' '$here/installed_and_purged.sh' /tmp" \
  --customize-hook="chroot \"\$1\" sh /tmp/installed_and_purged.sh /tmp/$(basename "${packages[0]}")" \
  bookworm /dev/null
