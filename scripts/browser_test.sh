#!/usr/bin/env bash
# browser_test.sh: opens the report of a small map in a headless Chromium, which is installed where it is missing, and
# clicks through it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/bootstrap.sh chromium chromium-driver
cmake --preset release
cmake --build --preset release --target rubsweep rubreport rubtrace
ctest --preset release -L browser --no-tests=error
