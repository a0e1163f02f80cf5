#!/usr/bin/env bash
# Builds everything and runs all tests but those that take minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/bootstrap.sh
cmake --preset release
cmake --build --preset release
# Some tests wait for what they started.
ctest --preset release -LE 'long|findings|audit|fuzz|browser|package' --parallel "$(($(nproc) + 1))"
