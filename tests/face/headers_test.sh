#!/usr/bin/env bash
# headers_test.sh SOURCE: the headers for people are few, and so are those that they need.
set -euo pipefail
cd "$1"
count=$(find lib/include/rubsweep -name '*.hpp' | wc -l)
((count <= 17)) || { echo "lib/include/rubsweep: $count headers, allowed: 17" >&2; exit 1; }
all=$(cmake -D LIBRARY=lib -P lib/installed_headers.cmake 2>&1 >/dev/null | wc -l)
((all > count && all <= 170)) || { echo "$all headers are installed, allowed: 170" >&2; exit 1; }
