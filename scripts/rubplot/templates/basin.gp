# Draws the slice of starts that pictures/basin.py lays out, one colour per attractor.
# Arguments: HEADING ATTRACTORS LEGEND OTHERS X_LABEL Y_LABEL WALL
# File: starts. ATTRACTORS: kind and rank among its kind, for each; LEGEND: what is said of each, a | behind it (of a
# subharmonic all, of others what stands behind the name of their kind); OTHERS: how many attractors have no name of their
# own; WALL: the axis (0: x) and the place of the first wall at rest, or nothing.

heading = ARG1
attractors = ARG2
rest_of_legend = ARG3
others = int(ARG4)
wall = ARG7
starts = "starts"
named = words(attractors) / 2

# Attractors of one kind are shades of its colour.
shade(c, rank) = sprintf("#%02X%02X%02X", mix(part(c, 1), rank), mix(part(c, 2), rank), mix(part(c, 3), rank))
mix(value, rank) = rank == 0 ? value : rank % 2 ? value + (255 - value) * (rank < 3 ? 0.5 : 0.75) : value * (rank < 4 ? 0.6 : 0.35)
array tint[named + 2]
array name[named + 2]
do for [k = 1:named] {
  found = 0
  do for [i = 1:kinds] { if (word(attractors, 2 * k - 1) eq kind[i]) { found = i } }
  if (found == 0) { exit error "basin.gp: unknown kind: " . word(attractors, 2 * k - 1) }
  tint[k] = shade(colour[found], int(word(attractors, 2 * k)))
  end = strstrt(rest_of_legend, "|")
  name[k] = (strstrt(kind[found], "subharmonic") == 1 ? "" : legend[found]) . rest_of_legend[1:end - 1]
  rest_of_legend = rest_of_legend[end + 1:*]
}
tint[named + 1] = "#BBBBBB"
name[named + 1] = sprintf("%d other attractors", others)
tint[named + 2] = "#CC0000"
name[named + 2] = "failed"

stats starts using 3:5 name "LOW" nooutput
stats starts using 4:6 name "HIGH" nooutput
stats starts using 7 name "NUMBER" nooutput
set xrange [LOW_min_x:HIGH_max_x]
set yrange [LOW_min_y:HIGH_max_y]
set title heading
set xlabel ARG5
# Not as the label of the axis, which may come over the numbers at it.
set lmargin at screen 0.1
set label 100 ARG6 at screen 0.02, graph 0.5 center rotate by 90
set xtics out nomirror
set ytics out nomirror
set encoding utf8
set minussign
set format x "% h"
set format y "% h"
set key at screen 0.685, graph 1 left top Left reverse samplen 1.5 spacing 1.4 font ",17"
set rmargin at screen 0.67
if (words(wall) == 2) {
  if (int(word(wall, 1)) == 0) {
    set arrow from first real(word(wall, 2)), graph 0 to first real(word(wall, 2)), graph 1 nohead front dashtype 2 linewidth 1.5
  } else {
    set arrow from graph 0, first real(word(wall, 2)) to graph 1, first real(word(wall, 2)) nohead front dashtype 2 linewidth 1.5
  }
}
number(k) = k == named + 2 ? 0 : k
is_shown(k) = k <= named || (k == named + 1 ? others > 0 : NUMBER_min == 0)

do for [format in formats] {
  eval canvas(format, 1600, 1000, 'DejaVu Sans,20', 1.5)
  plot for [k = 1:named + 2] starts using ($7 == number(k) ? $1 : NaN):2:3:4:5:6 with boxxyerror linecolor rgb tint[k] \
         linewidth 0.5 fillstyle solid 1 border notitle, \
       for [k = 1:named + 2] NaN with boxes linecolor rgb tint[k] fillstyle solid 1 noborder title (is_shown(k) ? name[k] : ""), \
       NaN with lines linecolor rgb "black" dashtype 2 linewidth 1.5 title (words(wall) == 2 ? "wall at rest" : "")
  unset output
}
