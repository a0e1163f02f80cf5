# Draws the branches that pictures/branch.py lays out.
# Arguments: HEADING ORDERS PIECES MARKS LABEL SCALE UNIT
# Files: those named in PIECES, stable_N and unstable_N of orders N in ORDERS, and one of every kind in MARKS; SCALE: logx or
# nothing.

heading = ARG1
orders = ARG2
pieces = ARG3
marks = ARG4
x_label = ARG5
if (ARG6 eq "logx") { set logscale x }

# Paul Tol's "muted" scheme, order by order from the lowest one.
array colours[5] = ["#332288", "#CC6677", "#117733", "#DDCC77", "#882255"]
is_stable(piece) = piece[1:1] eq "s"
order_of(piece) = piece[strstrt(piece, "_") + 1:*]
rank(piece) = sum [i = 1:words(orders)] (word(orders, i) eq order_of(piece) ? i : 0)
colour(piece) = colours[1 + int(rank(piece) - 1) % 5]
kinds = "fold period_doubling period_halving neimark_sacker branch_point graze"
array shape[6] = [7, 5, 4, 9, 13, 2]
array shape_size[6] = [1.8, 1.6, 1.6, 1.9, 1.9, 0.7]
place(k) = sum [i = 1:words(kinds)] (word(kinds, i) eq word(marks, k) ? i : 0)
name_of(k) = word("fold period-doubling period-halving torus branch-point graze", place(k))

set title heading
set xlabel x_label noenhanced
eval rpm_above(x_label)
set offsets graph 0.02, graph 0.02, 0, 0
# Not as the label of the axis, which may come over the numbers at it.
set lmargin at screen 0.1
set label 100 "amplitude (" . ARG7 . ")" at screen 0.02, graph 0.5 center rotate by 90
set tics nomirror out
set grid linecolor rgb "#E4E4E4"
set key at screen 0.79, graph 1 left top Left reverse samplen 2 spacing 1.4
set rmargin at screen 0.77
set datafile missing "NaN"

lines = 'for [piece in pieces] piece using 1:2 with lines linewidth is_stable(piece) ? 2.2 : 1.3 \
  dashtype is_stable(piece) ? 1 : 2 linecolor rgb colour(piece) \
  title sprintf("order %s, %s", order_of(piece), is_stable(piece) ? "stable" : "unstable")'
# gnuplot reads the body of an empty loop, too.
events = 'for [k = 1:words(marks)] word(marks, k) using 1:2 with points pointtype shape[int(place(k))] \
  pointsize shape_size[int(place(k))] linecolor rgb "#000000" title name_of(k)'
do for [format in formats] {
  eval canvas(format, 1600, 1000, 'DejaVu Sans,20', 1.5)
  eval "plot " . lines . (words(marks) ? ", " . events : "")
  unset output
}
