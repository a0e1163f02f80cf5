#!/usr/bin/env bash
# Installs the Debian packages that building, testing and drawing need, and any others named as arguments.
# Asks the network only when something is missing.
set -euo pipefail

packages=(g++ cmake ninja-build pkg-config git
  libboost1.81-dev libboost-program-options1.81-dev libeigen3-dev libfftw3-dev libtbb-dev libyaml-cpp-dev libfmt-dev
  libtomlplusplus-dev nlohmann-json3-dev zlib1g-dev libhdf5-dev libmatio-dev libsndfile1-dev libceres-dev node-d3 libgtest-dev
  nettle-dev libbenchmark-dev libopenmpi-dev openmpi-bin fonts-dejavu-core "$@")
# Any Python from 3.9 on will do, wherever it comes from.
python3 -c 'import sys; sys.exit(sys.version_info < (3, 9))' 2>/dev/null || packages+=(python3)
# Any flavour of gnuplot will do, and they exclude each other.
command -v gnuplot >/dev/null || packages+=(gnuplot-nox)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed* ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

echo "Installing: ${missing[*]}"
as_root=(env DEBIAN_FRONTEND=noninteractive)
((EUID == 0)) || as_root=(sudo "${as_root[@]}")
"${as_root[@]}" apt-get update -q
"${as_root[@]}" apt-get install -q -y --no-install-recommends "${missing[@]}"
