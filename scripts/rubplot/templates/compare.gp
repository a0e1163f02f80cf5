# Draws the verdicts that pictures/compare.py lays out, one colour for each.
# Arguments: HEADING VERDICTS COLOURS X_LABEL Y_LABEL SCALES
# Files: the cells of each of the VERDICTS, and legend.gp with their names; SCALES: logx and logy where an axis is logarithmic.

verdicts = ARG2
colours = ARG3
load "legend.gp"

set title ARG1
set xlabel ARG4
eval rpm_above(ARG4)
# Not as the label of the axis, which may come over the numbers at it.
set lmargin at screen 0.1
set label 100 ARG5 at screen 0.02, graph 0.5 center rotate by 90
if (strstrt(ARG6, "logx")) { set logscale x }
if (strstrt(ARG6, "logy")) { set logscale y }
set tics out nomirror
set rmargin at screen 0.74
set key at screen 0.755, graph 1 left top Left reverse samplen 1.5 spacing 1.4
set autoscale noextend
do for [format in formats] {
  eval canvas(format, 1600, 1000, 'DejaVu Sans,20', 1.5)
  plot for [k = 1:words(verdicts)] word(verdicts, k) using 1:2:3:4:5:6 with boxxyerror linecolor rgb word(colours, k) \
    linewidth 0.5 fillstyle solid 1 border title name[k]
  unset output
}
