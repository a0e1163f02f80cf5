# Draws what analysis/threshold_map.py lays out: a colour for the threshold of each cell, and contours.
# gnuplot -c threshold_map.gp CELLS OUTPUT_BASENAME HEADING X_LABEL Y_LABEL THRESHOLD_LABEL LEVELS
# CELLS: boxes as index 0, the grid as index 1; LEVELS: parted by commas, empty where there are none.

cells = ARG1
output = ARG2
heading = ARG3
levels = ARG7

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
set cblabel ARG6 . ", smallest after which rub goes on"
set title heading
set xlabel ARG4
# Not as the label of the axis, which may come over the numbers at it.
set lmargin at screen 0.1
set label 100 ARG5 at screen 0.02, graph 0.5 center rotate by 90
set xtics out nomirror
set ytics out nomirror
set key outside below Left reverse samplen 1.5
with_threshold(x) = strcol(7) eq "NaN" ? NaN : x
without(x) = strcol(7) eq "NaN" ? x : NaN

set terminal pngcairo size 1600, 1000 font "DejaVu Sans,20" linewidth 1.5
set output output . ".png"
contours = strlen(levels) ? ", $contours using 1:2 with lines linewidth 1.5 linecolor rgb '#000000' title 'contours at ".levels."'" : ""
eval "plot cells index 0 using (without($1)):2:3:4:5:6 with boxxyerror linecolor rgb '#D9D9D9' linewidth 0.5 fillstyle solid 1 border title 'no rub goes on', cells index 0 using (with_threshold($1)):2:3:4:5:6:7 with boxxyerror linecolor palette linewidth 0.5 fillstyle solid 1 border notitle" . contours
set terminal svg size 1600, 1000 font "DejaVu Sans,20" linewidth 1.5
set output output . ".svg"
replot
