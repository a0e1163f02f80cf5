#!/usr/bin/env bash
# rubbench: what it writes, what it prints and how it ends.
source "$(dirname "$0")/support.sh"
few=(--turns 6 --repeats 1 --steppers dopri5,rkf78 --tolerances 1e-5,1e-8)

# Command line.
expect_help cell steppers tolerances turns repeats labels label-seconds
expect_usage_error 'a configuration file is needed'
expect_usage_error '--cell 75: allowed: SPEED_HZ,UNBALANCE' "$minimal" --cell 75
expect_usage_error '--cell 0,0.4: allowed' "$minimal" --cell 0,0.4
expect_usage_error "--steppers: 'euler', allowed: dopri5, " "$minimal" --steppers dopri5,euler
expect_usage_error "--tolerances: '1', allowed: numbers from 1e-14" "$minimal" --tolerances 1e-6,1
expect_usage_error '--turns: allowed: a number >= 6' "$minimal" --turns 5
expect_usage_error '--repeats: allowed: a number >= 1' "$minimal" --repeats 0
expect_usage_error '--labels: allowed' "$minimal" --labels 12
expect_usage_error '--labels: allowed' "$minimal" --labels 0x6
expect_usage_error 'without labels no cell can be chosen' "$minimal" --labels 0x0

# Configuration and files that cannot be had.
expect_exit 2 "$minimal" --set rotor.mass_kg=-1
expect_exit 2 "$minimal" --labels 0x0 --cell 90,0.4 --set gravity_m_per_s2=99 --set stops.0.angle_deg=-90
expect_contains stderr 'static forces press the rotor on the wall'
expect_exit 3 no_such_file.yaml
echo precious >file
expect_exit 3 "$minimal" --output file/below
rm -rf results

# A table with labels; the cell is chosen: a rub.
expect_exit 0 "$minimal" "${few[@]}" --labels 3x2 --label-seconds 100
expect_empty stderr
mv results/minimal_bench bench
expect_files bench config.yaml work_precision.csv
table=bench/work_precision.csv
[[ $(grep -v '^#' $table | head -n 1) == cell,method,stepper,contact,tolerance,microseconds_per_revolution,state_error\
,label_agreement,steps,switches,rhs_calls,status,reference,reference_error ]] || fail "$table has another header"
[[ $(grep -vc -e '^#' -e '^cell,' $table) == 9 ]] || fail 'not exact and 2 x 2 x 2 adaptive variants'
expect_matches $table '^# .* Hz whirl .*: reference in long double'
expect_matches $table ',exact,,located,,[0-9.e-]+,[0-9.e-]+,1,[0-9]+,[0-9]+,0,ok,long_double,[0-9.e-]+$'
for contact in located smoothed; do
  for stepper in dopri5 rkf78; do
    for tolerance in 1e-05 1e-08; do expect_matches $table ",adaptive,$stepper,$contact,$tolerance,"; done
  done
done
[[ $(count_rows $table "state_error > 1e-13 or reference_error > 1e-15 if method == 'exact' else contact == 'located' and state_error > 100 * tolerance") == 0 ]] ||
  fail 'a located variant is less exact than its tolerance'
expect_contains stdout 'labels: 6 of 6 cells can be kicked'
expect_matches stdout '^adaptive rkf78 smoothed 1e-08 '

# Its picture, where there is gnuplot.
if command -v gnuplot >/dev/null; then
  rubplot work-precision $table --output out/picture >stdout 2>stderr || fail 'no picture'
  expect_empty stdout
  expect_empty stderr
  [[ $(od -An -tu1 -j16 -N8 out/picture.png | awk '{ print $3 * 256 + $4, $7 * 256 + $8 }') == '1800 880' ]] ||
    fail 'the picture has another size'
fi

# A named cell, no labels; a variant that fails is named.
expect_exit 4 "$minimal" --labels 0x0 --cell 90,0.6 --turns 6 --repeats 1 --tolerances 1e-4,1e-13 --steppers dopri5 \
  --set solver.max_steps_per_revolution=1000 --output failed
expect_contains stdout '90 Hz whirl 0.6: adaptive dopri5 located 1e-13: step_limit'
expect_matches failed/work_precision.csv ',adaptive,dopri5,located,1e-13,,,,[0-9]+,[0-9]+,[0-9]+,step_limit,[^,]+,[^,]+$'
