# Draws the cells that pictures/map.py lays out, one colour per class and order.
# Arguments: HEADING PRESENT LABELS SPEED_LABEL UNBALANCE_LABEL BOUNDARIES OPTIONS
# File: cells. PRESENT: the kinds in it, a blank around each; LABELS: x y text x y text ...; the other two stand at the axes;
# OPTIONS: fade where cells are shown by as much of their colour as their strength says, logx and logy where an axis is
# logarithmic;
# BOUNDARIES: the kinds of lines behind the cells, a block for each.

cells = "cells"
heading = ARG1
present = ARG2
labels = ARG3
speed_label = ARG4
unbalance_label = ARG5
boundaries = ARG6
boundary_dash(k) = word(boundaries, k) eq "fold" ? 1 : word(boundaries, k) eq "doubling" ? 2 : word(boundaries, k) eq "torus" ? 3 : 4
boundary_name(k) = word(boundaries, k) eq "fold" ? "orbit ends in a fold" : word(boundaries, k) eq "doubling" ? "period doubles" : \
  word(boundaries, k) eq "torus" ? "torus" : "orbit ends otherwise"
in_natural_frequencies = strstrt(speed_label, "natural frequency") > 0
by_ratio = strstrt(unbalance_label, "whirl ratio") == 1

solid = ""
hatched = ""
do for [i = 1:kinds] {
  if (strstrt(present, " " . kind[i] . " ")) {
    if (i <= kinds - 3) { solid = solid . i . " " } else { hatched = hatched . i . " " }
  }
}

if (words(solid . hatched) != words(present)) { exit error "map.gp: unknown class among:" . present }

stats cells index 0 using 3:5 name "LOW" nooutput
stats cells index 0 using 4:6 name "HIGH" nooutput
set xrange [LOW_min_x:HIGH_max_x]
set yrange [LOW_min_y:HIGH_max_y]
if (in_natural_frequencies) {
  do for [n = int(ceil(LOW_min_x)):int(floor(HIGH_max_x))] {
    set arrow from n, graph 0 to n, graph 1 nohead front dashtype 2 linewidth 1.5 linecolor rgb "#444444"
  }
}
# Above it the rotor starts at rest and comes to the wall by itself; below it is kicked.
if (by_ratio && LOW_min_y < 1 && HIGH_max_y > 1.0000001) {
  set arrow from graph 0, first 1 to graph 1, first 1 nohead front linewidth 2.5 linecolor rgb "#000000"
}

set style textbox opaque noborder margins 0.4, 0.4
do for [k = 1:words(labels):3] {
  set label word(labels, k + 2) at real(word(labels, k)), real(word(labels, k + 1)) center front boxed font ",16"
}

set title heading
set xlabel speed_label
eval rpm_above(speed_label)
# Not as the label of the axis, which may come over the numbers at it.
set lmargin at screen 0.1
set label 100 unbalance_label at screen 0.02, graph 0.5 center rotate by 90
if (in_natural_frequencies) { set xtics 1 out nomirror; set mxtics 2 } else { set xtics autofreq out nomirror }
set ytics out nomirror
set key at screen 0.775, graph 1 left top Left reverse samplen 1.5 spacing 1.4
set rmargin at screen 0.76
if (strstrt(present, " quasi_periodic_oval ")) {
  set label "quasi-periodic oval: whirl that\nis closed in the rotating frame" at screen 0.78, screen 0.16 left font ",15"
}
at(list, k) = k > words(list) ? kinds : int(word(list, k))  # gnuplot reads the body of an empty loop, too
x_if(i) = strcol(7) eq kind[i] ? $1 : NaN

# A cell of strength 0 keeps a fifth of its colour, mixed with white.
mixed(level, strength) = int(255 - (0.2 + 0.8 * strength) * (255 - level) + 0.5)
faded(i, strength) = 65536 * mixed(part(colour[i], 1), strength) + 256 * mixed(part(colour[i], 2), strength) + \
  mixed(part(colour[i], 3), strength)
fade = strstrt(ARG7, "fade") > 0
if (strstrt(ARG7, "logx")) { set logscale x }
if (strstrt(ARG7, "logy")) { set logscale y }
if (fade) { set label "fainter: fewer of the neighbouring\nkicks lead to the same motion" at screen 0.78, screen 0.08 left font ",15" }

do for [format in formats] {
  eval canvas(format, 1600, 1000, 'DejaVu Sans,20', 1.5)
  # The legend of faded cells is drawn beside the map, in full colours.
  if (fade) {
    plot for [k = 1:words(solid)] cells index 0 using (x_if(at(solid, k))):2:3:4:5:6:(faded(at(solid, k), $8)) \
           with boxxyerror linecolor rgb variable linewidth 0.5 fillstyle solid 1 border notitle, \
         for [k = 1:words(solid)] NaN with boxes linecolor rgb colour[at(solid, k)] fillstyle solid 1 border \
           title legend[at(solid, k)], \
         for [k = 1:words(hatched)] cells index 0 using (x_if(at(hatched, k))):2:3:4:5:6:(faded(at(hatched, k), $8)) \
           with boxxyerror linecolor rgb variable linewidth 0.5 fillstyle pattern (at(hatched, k) - kinds + 6) border \
           notitle, \
         for [k = 1:words(hatched)] NaN with boxes linecolor rgb colour[at(hatched, k)] \
           fillstyle pattern (at(hatched, k) - kinds + 6) border title legend[at(hatched, k)], \
         for [k = 1:words(boundaries)] cells index (k > words(boundaries) ? 0 : k) using 1:2 with lines linecolor rgb "#000000" linewidth 1.3 \
           dashtype boundary_dash(k) title boundary_name(k)
  } else {
    plot for [k = 1:words(solid)] cells index 0 using (x_if(at(solid, k))):2:3:4:5:6 with boxxyerror \
           linecolor rgb colour[at(solid, k)] linewidth 0.5 fillstyle solid 1 border title legend[at(solid, k)], \
         for [k = 1:words(hatched)] cells index 0 using (x_if(at(hatched, k))):2:3:4:5:6 with boxxyerror \
           linecolor rgb colour[at(hatched, k)] linewidth 0.5 fillstyle pattern (at(hatched, k) - kinds + 6) border \
           title legend[at(hatched, k)], \
         for [k = 1:words(boundaries)] cells index (k > words(boundaries) ? 0 : k) using 1:2 with lines linecolor rgb "#000000" linewidth 1.3 \
           dashtype boundary_dash(k) title boundary_name(k)
  }
  unset output
}
