#!/usr/bin/env bash
# rubsweep-compare: what it says of two maps, what it draws and how it ends.
source "$(dirname "$0")/support.sh"
compare=$4

# expect_compared CODE [ARGUMENT]...
expect_compared() {
  local expected=$1 code=0
  shift
  "$compare" "$@" >stdout 2>stderr </dev/null || code=$?
  [[ $code == "$expected" ]] || fail "rubsweep-compare $*: exit code $code, expected $expected"
}

expect_exit 0 "${quick[@]}" --output a
expect_exit 0 "${quick[@]}" --output b --set solver.relative_tolerance=1e-9
expect_compared 0 a/map.csv a/map.csv --tolerance 0
expect_matches stdout '^96 cells: 96 equal, '
expect_matches stdout '^equal$'
expect_empty stderr
# Two tolerances of the solver: other last digits, the same map. The digests say that it is another study.
expect_compared 0 a/map.csv b/map.csv
expect_matches stdout '^digests: [0-9a-f-]{36} and [0-9a-f-]{36}, two studies$'
expect_compared 0 a/map.csv b/map.csv --quiet
expect_empty stdout

# A changed class, as a regression would show it.
sed '10s/non_contact,,/subharmonic,3,/' a/map.csv >changed.csv
expect_compared 3 a/map.csv changed.csv
expect_contains stderr 'changed.csv: is not as it was written: its sha256 is '
reseal changed.csv
{ sed -n '/^speed_hz,/p; 10p' a/map.csv; } >tenth.csv
IFS=, read -r speed_hz whirl_ratio < <(cells tenth.csv speed_hz whirl_ratio)
expect_compared 5 a/map.csv changed.csv --figure difference.gp
expect_contains stdout "speed_hz $speed_hz, whirl_ratio $whirl_ratio: non_contact -> subharmonic 1/3"
expect_matches stdout '^different$'
expect_contains difference.gp "$speed_hz $whirl_ratio"
printf 'speed_hz,whirl_ratio\n%s,%s\n' "$speed_hz" "$whirl_ratio" >list.csv
expect_compared 5 a/map.csv changed.csv --quiet --cells cells.csv
expect_contains cells.csv '# a a/map.csv'
expect_contains cells.csv '# tolerance 0.0001'
[[ $(count_rows cells.csv "verdict == 'equal'") == 95 ]] || fail "not one cell of 96 is another one: $(<cells.csv)"
[[ $(cells cells.csv speed_hz whirl_ratio verdict label_b | grep differ) == "$speed_hz,$whirl_ratio,classes_differ,subharmonic 1/3" ]] ||
  fail 'another verdict'
expect_compared 3 a/map.csv changed.csv --quiet --cells nowhere/cells.csv
expect_contains stderr 'cannot write nowhere/cells.csv'
expect_compared 0 a/map.csv changed.csv --sensitive list.csv
expect_contains stdout 'not compared: 1 sensitive cells, 1 of them with another class'
# Why a label changed: each cell runs again by the program that made its map, here one program with two kicks.
cell=(--set "sweep.speed_hz={values: [70]}" --set "sweep.whirl_ratio={values: [0.2]}")
expect_exit 0 "$minimal" "${cell[@]}" --output hard
expect_exit 0 "$minimal" "${cell[@]}" --output weak --set kick.force_n=50
changed_labels() { "$top/scripts/changed_labels.sh" "$rubsweep" "$1" "$rubsweep" "$2" >stdout 2>stderr </dev/null; }
changed_labels weak hard || fail changed_labels.sh
expect_matches stdout '^70,0.200,non_contact,subharmonic 1/[0-9]* [a-z]*,non_contact 11,subharmonic 1/[0-9]* [a-z]* 11,program$'
changed_labels weak weak || fail changed_labels.sh
[[ $(wc -l <stdout) == 1 ]] || fail 'no cell has another label'
sed -i 's/,non_contact,/,chaotic,/' weak/map.csv
reseal weak/map.csv
! changed_labels weak hard || fail 'nobody made this map'
expect_matches stderr 'weak/map.csv: 70 Hz and 0.2 is chaotic, .* says non_contact$'

# A smaller grid.
expect_exit 0 "${quick[@]}" --output c --set sweep.speed_hz.count=11
expect_compared 5 a/map.csv c/map.csv
expect_matches stdout 'in one map only$'

# Maps are read a row at a time: these two would take some 200 MB as tables.
grep -e '^#' -e '^speed_hz,' a/map.csv | grep -v -e '^# format ' -e '^# sha256 ' >many.csv
for ((i = 1000; i < 1600; ++i)); do rows a/map.csv | sed "s/^/$i/"; done >>many.csv
(
  ulimit -v 100000
  expect_compared 0 many.csv many.csv
)
expect_matches stdout '^57600 cells: 57600 equal, '

if command -v gnuplot >/dev/null; then
  expect_compared 5 a/map.csv changed.csv --figure difference.png
  [[ $(head -c 4 difference.png | tail -c 3) == PNG ]] || fail 'no picture'
  gnuplot difference.gp && expect_contains difference.gp "set output 'difference.png'"
  expect_compared 5 a/map.csv changed.csv --figure difference.svg
  for text in 'another class (1)' 'Where two maps differ' 'changed.csv; numbers to a tolerance of' 'shaft speed (Hz)' \
    'whirl ratio (quiet whirl / clearance)'; do
    expect_contains difference.svg "$text"
  done
  rubplot compare cells.csv --output cells >stdout 2>stderr || fail 'rubplot compare'
  expect_empty stderr
  for text in 'another class (1)' 'equal (95)' 'Where two maps differ' 'numbers to a tolerance of 0.0001'; do
    expect_contains cells.svg "$text"
  done
  expect_compared 3 a/map.csv a/map.csv --figure nowhere/difference.png
  expect_contains stderr 'cannot write nowhere/difference.png: No such file or directory'
  expect_compared 3 a/map.csv a/map.csv --quiet --figure nowhere/difference.png
  expect_empty stdout
  [[ $(<stderr) == 'rubsweep-compare: cannot write nowhere/difference.png: No such file or directory' ]] ||
    fail 'more than a message'

  # A user's settings of gnuplot decide nothing.
  mkdir -p home/.config/gnuplot
  echo 'set output "obeyed"; set title "obeyed"' | tee home/.gnuplot >home/.config/gnuplot/gnuplotrc
  HOME=$PWD/home XDG_CONFIG_HOME=$PWD/home/.config expect_compared 5 a/map.csv changed.csv --figure settings.svg
  expect_same <(sed 's/<desc>.*//' settings.svg) <(sed 's/<desc>.*//' difference.svg)
  expect_missing obeyed

  # Names are data, whatever they hold, and what is drawn goes to that name.
  evil=$'m\nsystem("touch pwned-by-map")\n\'`touch pwned-by-backticks`\'.csv'
  cp a/map.csv "$evil"
  for picture in '|touch pwned-by-figure;.png' '<touch pwned;.png' $'f\nsystem("touch pwned")\n.png' "q'\"\`touch pwned\`.png" '~root.png'; do
    expect_compared 5 "$evil" changed.csv --quiet --figure "$picture"
    expect_empty stdout
    [[ $(head -c 4 "./$picture" | tail -c 3) == PNG ]] || fail "no picture: $picture"
  done
  expect_compared 5 "$evil" changed.csv --quiet --figure '|touch pwned-by-script;.gp'
  gnuplot ./'|touch pwned-by-script;.gp'
  [[ $(head -c 4 './|touch pwned-by-script;.png' | tail -c 3) == PNG ]] || fail 'no picture of the script'
  expect_compared 3 a/map.csv changed.csv --quiet --figure $'f\nsystem("touch pwned")\n.gp'
  expect_contains stderr 'its name has control characters'
  [[ -z $(find . -name 'pwned*') ]] || fail "a name became a command: $(find . -name 'pwned*')"
fi

expect_compared 3 a/map.csv missing.csv
expect_contains stderr 'rubsweep-compare: cannot read missing.csv: No such file or directory'
expect_compared 3 a/map.csv a/config.yaml
expect_compared 1 a/map.csv
expect_contains stderr 'rubsweep-compare: two maps are needed'
expect_compared 1 a/map.csv a/map.csv --tolerance -1
expect_compared 1 a/map.csv a/map.csv --tolerance nan
expect_compared 1 a/map.csv a/map.csv --figure difference.pdf
expect_compared 0 --help
expect_contains stdout 'Exit codes: 0 the maps are equal on robust cells; 1 usage; 3 input/output; 5 they differ.'
expect_compared 0 --version
[[ $(head -n 1 stdout) == "rubsweep-compare $version" ]] || fail 'another version'
