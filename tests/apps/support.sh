# Sourced first by every test here, with the test's own arguments: the program, the top of the repository, its version.
# The test then works in a directory of its own, which is removed when it ends.
# shellcheck shell=bash disable=SC2034
set -euo pipefail
export LC_ALL=C.UTF-8
rubsweep=$1
top=$2
version=$3
minimal=$top/configs/minimal.yaml
# The same with a kick too weak to reach the wall: a fifth of a millisecond for each cell.
quick=("$minimal" --set kick.force_n=50 --set sweep.speed_hz.count=12 --set 'sweep.whirl_ratio={from: 0.02, to: 0.2, count: 8}')
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Columns of map.csv.
header=speed_hz,whirl_ratio,eccentricity_m,class,order,orbit,whirl,proof,robust,comb_spacing,hits_per_revolution\
,contact_fraction,peak_displacement_m,peak_contact_force_n,amplitude_1x_forward_m,amplitude_1x_backward_m\
,dominant_order,dominant_amplitude_m,floquet_modulus,lyapunov_per_revolution,last_contact_revolution,revolutions,status,start\
,peak_casing_displacement_m,peak_over_clearance,chaos_life_revolutions,chaos_escapes,kind

# fail MESSAGE: ends the test, with the line that failed and what the program printed last.
fail() {
  printf '%s:%s: %s\n' "$0" "${BASH_LINENO[-2]}" "$1"
  tail -n 20 -v stdout stderr 2>&1
  exit 1
} >&2

# expect_exit CODE [ARGUMENT]...: runs the program; what it prints is in the files stdout and stderr from then on.
expect_exit() {
  local expected=$1 code=0
  shift
  "$rubsweep" "$@" >stdout 2>stderr </dev/null || code=$?
  [[ $code == "$expected" ]] || fail "rubsweep $*: exit code $code, expected $expected"
}

# expect_usage_error TEXT [ARGUMENT]...: the program says TEXT and where to read on, and writes nothing.
expect_usage_error() {
  local text=$1 program=${rubsweep##*/}
  shift
  expect_exit 1 "$@"
  expect_empty stdout
  expect_contains stderr "$program: $text"
  expect_contains stderr "Try: $program --help"
  expect_missing results
}

# expect_help OPTION...: --help names the program and these options, --version the version.
expect_help() {
  local program=${rubsweep##*/} option
  expect_exit 0 --help
  expect_empty stderr
  expect_contains stdout "$program CONFIG.yaml"
  for option in "$@" set output quiet help version; do expect_matches stdout "^  --$option "; done
  expect_exit 0 --version
  expect_empty stderr
  [[ $(head -n 1 stdout) == "$program $version" ]] || fail "expected: $program $version"
  expect_matches stdout '^commit ([0-9a-f]{12}(-dirty)?|unknown)$'
  expect_matches stdout '^compiler [A-Za-z]+ [0-9.]+$'
  [[ $(wc -l <stdout) == 3 ]] || fail 'expected three lines: version, commit, compiler'
}

# expect_contains FILE TEXT
expect_contains() { grep -qF -e "$2" "$1" || fail "$1 does not contain: $2"; }

# expect_matches FILE EXTENDED_REGULAR_EXPRESSION
expect_matches() { grep -qE -e "$2" "$1" || fail "$1 does not match: $2"; }

# expect_empty FILE
expect_empty() { [[ -f $1 && ! -s $1 ]] || fail "$1 is not empty: $(<"$1")"; }

# expect_missing PATH
expect_missing() { [[ ! -e $1 ]] || fail "$1 exists"; }

# expect_files DIRECTORY [NAME]...: it holds these and nothing else.
expect_files() {
  local directory=$1
  shift
  diff <(printf '%s\n' "$@" | sort) <(find "$directory" -mindepth 1 -printf '%P\n' | sort) >&2 ||
    fail "$directory does not hold exactly: $*"
}

# expect_same FILE FILE
expect_same() { diff "$1" "$2" >&2 || fail "$1 and $2 differ"; }

# header_of TABLE: its first line that is no comment.
header_of() { grep -m 1 -v '^#' "$1"; }

# expect_whole_table TABLE...: each has the head of every table, and the checksum there is that of all other lines.
expect_whole_table() {
  local table
  for table; do
    [[ $(grep -c -e '^# rub[a-z-]* [0-9.]*$' -e '^# ringstab [0-9.]*$' -e '^# digest [0-9a-f-]\{36\}$' -e '^# format 1$' "$table") == 3 ]] ||
      fail "$table has another head: $(head -n 6 "$table")"
    [[ $(sed '/^# sha256 /d' "$table" | sha256sum | cut -d' ' -f1) == "$(sed -n 's/^# sha256 //p' "$table")" ]] ||
      fail "$table has another checksum"
  done
}

# reseal TABLE: a test changed it, and it gets the checksum of what it holds now.
reseal() {
  local sum
  sum=$(sed '/^# sha256 /d' "$1" | sha256sum)
  sed -i "s/^# sha256 .*/# sha256 ${sum%% *}/" "$1"
}

# rows MAP: the rows of a map, without comments and header.
rows() { grep -v -e '^#' -e '^speed_hz,' "$1" || true; }

# cells FILE.csv NAME...: the cells of these columns, a line per row, parted by commas.
cells() { PYTHONPATH=$top/scripts python3 -B "$top/scripts/analysis/csv_columns.py" "$@"; }

# rubplot ARGUMENT...: draws, from the sources.
rubplot() { python3 "$top/scripts/rubplot" "$@"; }

# count_rows FILE.csv CONDITION: how many rows make the condition true, see count_rows.py.
count_rows() { python3 -B "$top/tests/apps/count_rows.py" "$@"; }

# expect_whole_rows MAP: comments, header, then rows with every column, each ended.
expect_whole_rows() {
  sed -n 1p "$1" | grep -q '^# rubsweep ' || fail "$1 does not begin with its version"
  [[ $(grep -v '^#' "$1" | head -n 1) == "$header" ]] || fail "$1 has another header"
  [[ -z $(tail -c 1 "$1") ]] || fail "the last line of $1 has no end"
  local columns=${header//[^,]/}
  [[ -z $(rows "$1" | awk -F, -v columns=$((${#columns} + 1)) 'NF != columns') ]] || fail "$1 has cut rows"
}

# one_cell SPEED_HZ WHIRL_RATIO: sets `cell` to the arguments that reduce the grid of a configuration to this cell.
one_cell() { cell=(--set "sweep={speed_hz: {values: [$1]}, whirl_ratio: {values: [$2]}}"); }

# killed_at ROWS DIRECTORY [ARGUMENT]...: runs the program with --output DIRECTORY and kills it (-9) once ROWS cells are
# finished; it may have been done before, on a machine in a hurry, and then it begins anew. Leaves a map that is not whole.
killed_at() {
  local rows=$1 directory=$2 attempt running
  shift 2
  for attempt in 1 2 3 4 5; do
    rm -rf "$directory"
    "$rubsweep" "$@" --output "$directory" --threads 1 >stdout 2>stderr </dev/null &
    running=$!
    until [[ -e $directory/map.partial.csv ]] && (($(rows "$directory/map.partial.csv" | wc -l) >= rows)); do
      kill -0 "$running" 2>/dev/null || break
      sleep 0.002
    done
    kill -KILL "$running" 2>/dev/null || true
    wait "$running" 2>/dev/null || true
    [[ -e $directory/map.csv ]] || break
  done
  expect_missing "$directory/map.csv"
  expect_matches "$directory/map.journal" ' rubsweep journal 1$'
}

# expect_resumed ROWS WHOLE [ARGUMENT]...: killed once ROWS cells are finished, the same command goes on and writes the files
# of the directory WHOLE.
expect_resumed() {
  local rows=$1 whole=$2
  shift 2
  killed_at "$rows" killed "$@"
  expect_exit 0 "$@" --output killed
  expect_matches stderr '[0-9]+ of [0-9]+ cells were finished before'
  diff -r killed "$whole" >&2 || fail "killed and $whole differ"
}
