# Draws the branches that analysis/branch_layout.py lays out.
# gnuplot -c branch_figure.gp WORK OUTPUT_BASENAME HEADING ORDERS MARKS LABEL
# WORK holds stable_N and unstable_N of every order N in ORDERS, and a file of every kind in MARKS.

work = ARG1
output = ARG2
heading = ARG3
orders = ARG4
marks = ARG5
x_label = ARG6
file(name) = work . "/" . name

# Paul Tol's "muted" scheme, order by order from the lowest one.
array colours[5] = ["#332288", "#CC6677", "#117733", "#DDCC77", "#882255"]
colour(k) = colours[1 + (k - 1) % 5]
kinds = "fold period_doubling period_halving neimark_sacker branch_point graze"
array shape[6] = [7, 5, 4, 9, 13, 2]
array shape_size[6] = [1.8, 1.6, 1.6, 1.9, 1.9, 0.7]
place(k) = sum [i = 1:words(kinds)] (word(kinds, i) eq word(marks, k) ? i : 0)
name_of(k) = word("fold period-doubling period-halving torus branch-point graze", place(k))

set title heading
set xlabel x_label noenhanced
# Not as the label of the axis, which may come over the numbers at it.
set lmargin at screen 0.1
set label 100 "amplitude (mm)" at screen 0.02, graph 0.5 center rotate by 90
set tics nomirror out
set grid linecolor rgb "#E4E4E4"
set key at screen 0.79, graph 1 left top Left reverse samplen 2 spacing 1.4
set rmargin at screen 0.77
set datafile missing "NaN"

set terminal pngcairo size 1600, 1000 font "DejaVu Sans,20" linewidth 1.5
set output output . ".png"
plot for [k = 1:words(orders)] file("stable_" . word(orders, k)) using 1:2 with lines linewidth 2.2 \
       linecolor rgb colour(k) title "order " . word(orders, k) . ", stable", \
     for [k = 1:words(orders)] file("unstable_" . word(orders, k)) using 1:2 with lines linewidth 1.3 dashtype 2 \
       linecolor rgb colour(k) title "order " . word(orders, k) . ", unstable", \
     for [k = 1:words(marks)] file(word(marks, k)) using 1:2 with points pointtype shape[int(place(k))] \
       pointsize shape_size[int(place(k))] linecolor rgb "#000000" title name_of(k)
set terminal svg size 1600, 1000 font "DejaVu Sans,20" linewidth 1.5
set output output . ".svg"
replot
