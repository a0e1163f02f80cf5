#!/usr/bin/env bash
# archive_test.sh BUILD: unpacks the archive of BUILD anywhere and computes a first map with it, in an environment that has
# nothing but a PATH.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

(cd "$build" && cpack -G TGZ -B "$work/packed" >"$work/cpack.log" 2>&1) || { cat "$work/cpack.log"; exit 1; }
mkdir "$work/here and there" "$work/empty"
tar -xf "$work"/packed/rubsweep-*.tar.gz -C "$work/here and there" --strip-components 1
prefix="$work/here and there"
formats=''
! command -v gnuplot >/dev/null || formats='png svg'
cd "$work/empty"
env -i PATH="$prefix/bin:/usr/bin:/bin" sh "$here/first_map.sh" "$prefix/share/doc/rubsweep/examples" "$formats"

# Documents whose links lead somewhere, beside each other as in the repository.
"$here/../../scripts/check_documents.sh" "$prefix/share/doc/rubsweep"
# Nothing but what was unpacked is used: no file of the archive names the build.
! grep -rlF -e "$build" "$prefix/bin/rubplot" "$prefix/share" "$prefix/lib/cmake" || exit 1
