#!/usr/bin/env bash
# insert_tables.sh [--check] [--only TEXT] DOCUMENT...: makes the tables of documents anew. Such a table stands between the lines
#   <!-- Made by COMMAND,
#        commit X, on MACHINE -->
#   <!-- End of what is made. -->
# COMMAND is run by bash in the top folder and prints the table as Markdown; it may stand on several lines, those behind the
# first indented. Commit and machine become those of this run. With
# --only those tables alone whose command contains TEXT, since some take minutes. With --check nothing is written: exits 1 and
# names each table that differs from what its command prints now.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$here
exec python3 "$here/analysis/insert_tables.py" "$@"
