#!/usr/bin/env bash
# Names of files and cells of CSV files are data to the scripts that draw: none becomes a command. Arguments 4 and 5:
# rubtrace and rubbench.
source "$(dirname "$0")/support.sh"
command -v gnuplot >/dev/null || { echo 'skipped: there is no gnuplot'; exit 77; }
rubtrace=$4 rubbench=$5
one_cell 50 0.2
png() { [[ $(head -c 4 "$1" | tail -c 3) == PNG ]] || fail "no picture: $1"; }
expect_no_commands() {
  [[ -z $(find . -name 'pwned*') ]] || fail "a name became a command: $(find . -name 'pwned*')"
}
names=('|touch pwned-bar; ' '<touch pwned-less; ' 'a=b' "q'\"\`touch pwned-quotes\`" '$(touch pwned-shell)')

# A map.
expect_exit 0 "$minimal" --set sweep.speed_hz.count=3 --output map
for name in "${names[@]}"; do
  cp -r map "$name"
  rubplot map "$name/map.csv" --output "$name.png" --heading "$name" >stdout 2>stderr || fail "rubplot map $name"
  png "./$name.png"
  "$top/scripts/aperiodic_cells.sh" "$name/map.csv" >stdout 2>stderr </dev/null || fail "aperiodic_cells.sh $name"
  rm -r "./$name"
done
sed -i 's/non_contact/"; system("touch pwned-by-class"); "/' map/map.csv
reseal map/map.csv
rubplot map map/map.csv --output evil_map >stdout 2>stderr || true
expect_no_commands

# A trace, and cells of it that would be code in the shell's arithmetic and in gnuplot.
"$rubtrace" "$minimal" --speed-hz 50 --whirl-ratio 0.2 --revolutions 80 --output trace --quiet
for name in "${names[@]}"; do
  cp -r trace "$name"
  rubplot trace "$name" --output "$name.png" --heading "$name" >stdout 2>stderr || fail "rubplot trace $name"
  png "./$name.png"
  rm -r "./$name"
done
# spoil FILE SED_COMMAND: rubplot refuses the trace with this change.
spoil() {
  cp -r trace spoiled
  sed -i "$2" "spoiled/$1"
  reseal "spoiled/$1"
  code=0
  rubplot trace spoiled --output spoiled_picture >stdout 2>stderr || code=$?
  [[ $code != 0 ]] || fail "rubplot trace drew $1 after $2"
  expect_no_commands
  rm -r spoiled
}
spoil motion.csv '$s/non_contact/"; system("touch pwned-class") #/'
spoil motion.csv '$s/non_contact/x";system("touch${IFS}pwned-class")#/'
spoil motion.csv '$s/^50/system("touch pwned-speed")/'
spoil motion.csv '$s/non_contact,/&a[$(touch pwned-order)]/'
spoil section.csv '$s/^[0-9]*/a[$(touch pwned-section)]/'
spoil section.csv '/^0,/s/,[^,]*,[^,]*,[^,]*,/,0,0,system("touch pwned-start"),/'
spoil config.yaml 's/clearance_m: .*/clearance_m: system("touch pwned-clearance")/'
spoil config.yaml 's/window_revolutions: .*/window_revolutions: a[$(touch pwned-window)]/'
spoil config.yaml 's/duration_s: .*/duration_s: system("touch pwned-kick")/'

# A table of work against precision.
"$rubbench" "$minimal" --cell 90,0.6 --labels 0x0 --turns 6 --repeats 1 --tolerances 1e-6,1e-8 --quiet --output bench >stdout 2>stderr || fail 'rubbench'
table=$(find bench -name '*.csv' | head -n 1)
for name in "${names[@]}"; do
  cp "$table" "$name"
  rubplot work-precision "$name" --output "$name.png" --heading "$name" >stdout 2>stderr || fail "rubplot work-precision $name"
  png "./$name.png"
  rm "./$name"
done
# The first column is the title of its panels.
sed -E '/^(#|cell,)/!s/^[^,]*/"; system("touch pwned-title"); "`touch pwned-title-2`'"'"'; system("touch pwned-title-3") #/' "$table" >evil.csv
reseal evil.csv
rubplot work-precision evil.csv --output evil >stdout 2>stderr || fail 'rubplot work-precision evil.csv'
png evil.png
expect_no_commands
