# Draws what pictures/threshold.py lays out: a colour for the threshold of each cell, and contours.
# Arguments: HEADING X_LABEL Y_LABEL THRESHOLD_LABEL LEVELS SCALES
# File: cells, the boxes as index 0, the grid as index 1. LEVELS: parted by commas, empty where there are none; SCALES: logx
# and logy where an axis is logarithmic.

cells = "cells"
heading = ARG1
levels = ARG5

stats cells index 0 using 3:5 name "LOW" nooutput
stats cells index 0 using 4:6 name "HIGH" nooutput
stats cells index 0 using 7 name "THRESHOLD" nooutput

if (strlen(levels)) {
  set contour base
  set cntrparam linear
  eval "set cntrparam levels discrete " . levels
  unset surface
  set table $contours
  splot cells index 1 using 1:2:3
  unset table
  unset contour
}

set xrange [LOW_min_x:HIGH_max_x]
set yrange [LOW_min_y:HIGH_max_y]
set palette defined (0 "#332288", 0.25 "#4F9BD0", 0.5 "#44AA99", 0.75 "#DDCC77", 1 "#FBF3DC")
if (THRESHOLD_min > 0) { set logscale cb }
if (THRESHOLD_max > THRESHOLD_min) { set cbrange [THRESHOLD_min:THRESHOLD_max] }
set cblabel ARG4 . ", smallest after which rub goes on"
set title heading
set xlabel ARG2
eval rpm_above(ARG2)
# Not as the label of the axis, which may come over the numbers at it.
set lmargin at screen 0.1
set label 100 ARG3 at screen 0.02, graph 0.5 center rotate by 90
if (strstrt(ARG6, "logx")) { set logscale x }
if (strstrt(ARG6, "logy")) { set logscale y }
set xtics out nomirror
set ytics out nomirror
# A row of its own below the name of the axis.
set bmargin at screen 0.175
set key at screen 0.5, screen 0.005 center bottom horizontal Left reverse samplen 1.5 maxrows 1
with_threshold(x) = strcol(7) eq "NaN" ? NaN : x
without(x) = strcol(7) eq "NaN" ? x : NaN

do for [format in formats] {
  eval canvas(format, 1600, 1000, 'DejaVu Sans,20', 1.5)
  contours = strlen(levels) ? ", $contours using 1:2 with lines linewidth 1.5 linecolor rgb '#000000' title 'contours at ".levels."'" : ""
  eval "plot cells index 0 using (without($1)):2:3:4:5:6 with boxxyerror linecolor rgb '#D9D9D9' linewidth 0.5 fillstyle solid 1 border title 'no rub goes on', cells index 0 using (with_threshold($1)):2:3:4:5:6:7 with boxxyerror linecolor palette linewidth 0.5 fillstyle solid 1 border notitle" . contours
  unset output
}
