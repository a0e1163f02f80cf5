#!/bin/sh
# developed.sh PACKAGE.deb: installs the package rubsweep-dev with a compiler, and builds and runs the program of its examples,
# as root of a new Debian 12.
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
apt-get install -y -qq --no-install-recommends "$1" g++ cmake make >/tmp/apt.log 2>&1 || { cat /tmp/apt.log; exit 1; }
echo "installed: $(dpkg -L rubsweep-dev | wc -l) files and folders, $(dpkg-query -W -f='${Installed-Size}' rubsweep-dev) KiB"
built() {
  cmake -S /usr/share/doc/rubsweep-dev/examples -B /tmp/built -D CMAKE_BUILD_TYPE=Release && cmake --build /tmp/built
}
built >/tmp/cmake.log 2>&1 || { cat /tmp/cmake.log; exit 1; }
/tmp/built/one_cell >/tmp/said
cat /tmp/said
grep -q '^class subharmonic, order 2, proof floquet' /tmp/said
