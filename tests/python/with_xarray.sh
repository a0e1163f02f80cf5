#!/usr/bin/env bash
# with_xarray.sh ARGUMENTS...: runs the first Python that has xarray and pandas; ends with 77, which is a test skipped,
# where none has.
set -euo pipefail
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import pandas, xarray' 2>/dev/null; then exec "$python" -B "$@"; fi
done
echo 'skipped: no Python with xarray (Debian package: python3-xarray)'
exit 77
