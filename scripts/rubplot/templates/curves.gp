# Draws the curves that pictures/curves.py lays out, over the cells of a map where there is one.
# Arguments: HEADING KINDS CLASSES X_LABEL Y_LABEL MEETINGS SCALES
# Files: one of every kind in KINDS, meetings, and cells with the classes CLASSES (empty: no map). MEETINGS: how many; SCALES:
# logx and logy where an axis is logarithmic.

heading = ARG1
kinds_of_curves = ARG2
classes = ARG3
with_meetings = ARG6 > 0

with_map = words(classes) > 0

all_kinds = "fold period_doubling neimark_sacker branch_point graze"
place(k) = sum [i = 1:words(all_kinds)] (word(all_kinds, i) eq word(kinds_of_curves, k) ? i : 0)
name_of(k) = word("fold period-doubling torus branch-point graze", place(k))
array dash[5] = [1, 2, 4, 5, 3]
array curve_colour[5] = ["#000000", "#7A0000", "#00217A", "#005A1E", "#333333"]

set title heading
set xlabel ARG4 noenhanced
eval rpm_above(ARG4)
# Not as the label of the axis, which may come over the numbers at it.
set lmargin at screen 0.1
set label 100 ARG5 at screen 0.02, graph 0.5 center rotate by 90 noenhanced
set tics nomirror out
set key at screen 0.775, graph 1 left top Left reverse samplen 2 spacing 1.4
set rmargin at screen 0.76
if (strstrt(ARG7, "logx")) { set logscale x }
if (strstrt(ARG7, "logy")) { set logscale y }
set datafile missing "NaN"
if (with_map) {
  stats "cells" using 3:5 name "LOW" nooutput
  stats "cells" using 4:6 name "HIGH" nooutput
  set xrange [LOW_min_x:HIGH_max_x]
  set yrange [LOW_min_y:HIGH_max_y]
} else {
  set grid linecolor rgb "#E4E4E4"
  set offsets graph 0.02, graph 0.02, graph 0.02, graph 0.02
}
x_if(i) = strcol(7) eq kind[i] ? $1 : NaN
shown(i) = with_map && strstrt(" " . classes . " ", " " . kind[i] . " ") > 0
# gnuplot reads the body of an empty loop, too: one class that no cell has.
list = ""
do for [i = 1:kinds] { if (shown(i)) { list = list . i . " " } }
at(k) = k > words(list) ? kinds : int(word(list, k))

# Without a map the file of cells is empty, which would be a warning.
cells = !with_map ? "" : 'for [k = 1:words(list)] "cells" using (x_if(at(k))):2:3:4:5:6 with boxxyerror ' . \
  'linecolor rgb colour[at(k)] linewidth 0.5 fillstyle transparent solid 0.55 noborder title legend[at(k)], '
curves = 'for [k = 1:words(kinds_of_curves)] word(kinds_of_curves, k) using 1:2 with lines linewidth 2.4 ' . \
  'dashtype dash[int(place(k))] linecolor rgb curve_colour[int(place(k))] title name_of(k), '
meetings = '"meetings" using 1:2 with points pointtype 7 pointsize 1.2 linecolor rgb "#000000" title "meeting", ' . \
  '"meetings" using 1:2:3 with labels noenhanced left offset 0.8, 0.4 font ",13" notitle'
do for [format in formats] {
  eval canvas(format, 1600, 1000, 'DejaVu Sans,20', 1.5)
  eval "plot " . cells . curves . (with_meetings ? meetings : "NaN notitle")
  unset output
}
