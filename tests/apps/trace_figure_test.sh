#!/usr/bin/env bash
# rubplot draws what rubtrace wrote. Skipped without gnuplot.
source "$(dirname "$0")/support.sh"
command -v gnuplot >/dev/null || { echo 'skipped: there is no gnuplot'; exit 77; }
touch stdout stderr

# trace DIRECTORY ARGUMENT...
trace() { expect_exit 0 "$minimal" --output "$1" --revolutions 100 --quiet "${@:2}"; }
trace rub --speed-hz 90 --whirl-ratio 0.6
trace quiet --speed-hz 54 --whirl-ratio 0.2 --set gravity_m_per_s2=9.81
trace bare --speed-hz 54 --whirl-ratio 0.2 --set stops.0.casing=rigid --set stops.0.angle_deg=30

# draw EXPECTED_EXIT_CODE ARGUMENT...
draw() {
  local code=0
  rubplot trace "${@:2}" >stdout 2>stderr || code=$?
  [[ $code == "$1" ]] || fail "rubplot trace ${*:2}: exit code $code, expected $1"
}

# expect_picture BASENAME ROWS: both files, 590 pixels per row, and gnuplot had nothing to say.
expect_picture() {
  expect_empty stdout
  expect_empty stderr
  [[ $(od -An -tu1 -j16 -N8 "$1.png" | awk '{ print $3 * 256 + $4, $7 * 256 + $8 }') == "2000 $((120 + 590 * $2))" ]] ||
    fail "$1.png has another size"
  expect_matches "$1.svg" '</svg>'
}

draw 0 rub --output out/first --heading Heading
expect_picture out/first 1
for text in Heading 'subharmonic 1/2: 90 Hz (5400 rpm) = 3 × natural frequency, whirl ratio 0.6' 'time (ms)' 'moving wall' kick 1/2X; do
  expect_contains out/first.svg "$text"
done
draw 0 rub --output out/last --revolutions -12
expect_picture out/last 1
expect_contains out/last.svg 'time after revolution 88 (ms)'
draw 0 rub quiet bare --output out/rows --revolutions 20
expect_picture out/rows 3
expect_contains out/rows.svg 'no contact: 54 Hz (3240 rpm)'
draw 0 bare --output out/bare --revolutions 20
expect_picture out/bare 1
! grep -q 'moving wall' out/bare.svg || fail 'a rigid wall does not move'

# The first revolutions there are, of a trajectory that holds only the end of the run.
trace late --speed-hz 90 --whirl-ratio 0.6 --last-revolutions 60
draw 0 late --output out/late
expect_picture out/late 1
expect_contains out/late.svg 'time after revolution 40 (ms)'
draw 0 late --output out/late_end --revolutions -12
expect_contains out/late_end.svg 'time after revolution 88 (ms)'

# Above a whirl ratio of 1 there is no kick to be drawn.
trace above --speed-hz 90 --whirl-ratio 1.2
draw 0 above --output out/above
expect_picture out/above 1
! grep -q '>kick<' out/above.svg || fail 'a kick is drawn where there was none'
grep -q '>kick<' out/first.svg || fail 'the kick is missing'

draw 2 --output out/nothing
expect_contains stderr 'the following arguments are required: DIR'
draw 3 nowhere --output out/nothing
expect_matches stderr '^rubplot: cannot read nowhere/trajectory.csv$'
expect_missing out/nothing.png

# The programs draw it themselves, with rubplot, and say so before they run when they cannot.
expect_exit 0 "$minimal" --speed-hz 90 --whirl-ratio 0.6 --revolutions 100 --output own --figure pictures/own.png
expect_contains stdout 'figure    pictures/own.png'
expect_files pictures own.png
draw 0 own --output out/own.png
cmp out/own.png pictures/own.png || fail 'another picture'
expect_exit 0 "$top/configs/rotor_kit.yaml" --campbell 0:200:11 --output campbell --figure pictures/campbell.svg --quiet
expect_empty stdout
expect_contains pictures/campbell.svg 'critical speed'
expect_contains pictures/campbell.svg 'place along the shaft (mm)'
expect_exit 0 "$minimal" --campbell 0:100 --output jeffcott --figure pictures/jeffcott.svg --quiet
expect_contains pictures/jeffcott.svg 'whirl frequency (Hz)'
! grep -q 'place along the shaft' pictures/jeffcott.svg || fail 'a Jeffcott rotor has no shaft to bend'
expect_exit 0 "$minimal" --run-up 24:50:8 --eccentricity-m 2e-4 --with-stops --output through --figure pictures/through.svg --quiet
for text in 'Run-up through rub, 24 to 50 Hz' rpm 'at steady speed' 'order (backward &lt; 0 &lt; forward)' rubs; do
  expect_contains pictures/through.svg "$text"
done
expect_exit 0 "$top/configs/benchmark/annulus.yaml" --run-up 50:24:-8 --eccentricity-m 1e-4 --with-stops --output through \
  --figure pictures/down.png --quiet
[[ -s pictures/down.png ]] || fail 'no picture of a run-down'
# Without stops a run-up is a Bode plot.
expect_exit 0 "$top/configs/rotor_kit.yaml" --run-up 20:45:2 --eccentricity-m 2e-5 --output bode --figure pictures/bode.svg --quiet
for text in 'Run-up without stops, 20 to 45 Hz' rpm '1X amplitude (mm)' 'phase (°)' 'resonance 29.87 Hz' 'sensor 1, at 190 mm, 90°'; do
  expect_contains pictures/bode.svg "$text"
done
[[ -z $(grep -o 'Warning' stderr) ]] || fail 'gnuplot complains'
mkdir bin
ln -s "$(command -v python3)" bin/python3
PATH=$work/bin expect_exit 3 "$minimal" --speed-hz 90 --whirl-ratio 0.6 --output none --figure none.png
/usr/bin/grep -qF -- '--figure: there is no program called gnuplot to draw with' stderr || fail 'no word of gnuplot'
expect_missing none

# A program away from where it was built draws with the command of the user or not at all, never with what lies at the place
# where it was built.
mkdir away commands
cp "$rubsweep" away/rubtrace
ask=(away/rubtrace "$minimal" --speed-hz 90 --whirl-ratio 0.6 --revolutions 20 --quiet --output away/trace --figure away/trace.svg)
code=0
PATH=/usr/bin:/bin "${ask[@]}" 2>stderr || code=$?
[[ $code == 3 ]] || fail "exit code $code, expected 3"
expect_contains stderr '--figure: rubplot, which draws, is neither in '
expect_missing away/trace
printf '#!/bin/sh\nwhile [ "$1" != --output ]; do shift; done\necho "<svg>mine</svg>" >"$2"\n' >commands/rubplot
chmod +x commands/rubplot
PATH=$PWD/commands:/usr/bin:/bin "${ask[@]}" || fail 'the command rubplot is not called'
[[ $(<away/trace.svg) == '<svg>mine</svg>' ]] || fail 'another program drew'
