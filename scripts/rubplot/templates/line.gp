# Draws the bifurcation diagram that pictures/line.py lays out.
# Arguments: HEADING PRESENT PASSES LABEL CLEARANCE DIRECTION SCALE UNIT
# Files: section and peaks; CLEARANCE is nan where it changes along the line; SCALE: logx or nothing; PRESENT: the kinds in them, a blank around each.

heading = ARG1
present = ARG2
passes = ARG3
x_label = ARG4
clearance = real(ARG5)
direction = ARG6
# Points want more contrast than areas.
colour[1] = "#AAAAAA"

shown = ""
do for [i = 1:kinds] { if (strstrt(present, " " . kind[i] . " ")) { shown = shown . i . " " } }
if (words(shown) != words(present)) { exit error "line.gp: unknown class among:" . present }
is_shown(name) = strstrt(" " . passes . " ", " " . name . " ") > 0
array pass[3] = ["kick", "up", "down"]
array pass_legend[3] = ["from the kick", "upward", "downward"]
array mark[3] = [7, 9, 10]
array size_of[3] = [0.5, 0.7, 0.9]
array pass_colour[3] = ["#777777", "#CC6677", "#332288"]
several = words(passes) > 1

# Here, while no axis has a range: of what lies outside the range of an axis, stats sees nothing.
stats "section" using 1 name "X" nooutput
stats "section" using 2 name "Y" nooutput
margin = X_max > X_min ? 0.01 * (X_max - X_min) : 0.1
# A wall near the motion is in the picture; a far one does not shrink the motion to a line.
farthest = abs(Y_max) > abs(Y_min) ? abs(Y_max) : abs(Y_min)
wall = ARG5 ne "nan" && clearance < 4 * farthest
low = wall && clearance < Y_min ? clearance : Y_min
high = wall && clearance > Y_max ? clearance : Y_max
space = high > low ? 0.06 * (high - low) : high != 0 ? 0.1 * abs(high) : 1

# A note is a fourth line of the heading; the numbers of revolutions per minute stand below it.
lines = 1 + sum [i = 1:strlen(heading)] (heading[i:i] eq "\n")
top = lines > 3 && strlen(rpm_above(x_label)) ? 0.815 : 0.845

do for [format in formats] {
  eval canvas(format, 1600, 1200, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set label 1 heading at screen 0.42, 0.97 center
  set lmargin at screen 0.10
  set rmargin at screen 0.75
  set tics nomirror out
  set grid linecolor rgb "#E4E4E4"
  if (ARG7 eq "logx") {
    set logscale x
    set xrange [X_min / (X_max / X_min)**0.01:X_max * (X_max / X_min)**0.01]
  } else { set xrange [X_min - margin:X_max + margin] }

  set tmargin at screen top
  eval rpm_above(x_label)
  set bmargin at screen 0.42
  set format x ""
  # Not as labels of the axes: beside a fixed margin these may come over the numbers.
  set label 3 "section, " . direction . " (" . ARG8 . ")" at screen 0.015, 0.64 center rotate by 90
  set yrange [low - space:high + space]
  set key at screen 0.765, graph 1 left top Left reverse samplen 1 spacing 1.3
  if (wall) {
    set arrow 1 from graph 0, first clearance to graph 1, first clearance nohead dashtype 2 linewidth 1.5 linecolor rgb "black"
    set label 2 "clearance at rest" at graph 0.01, first clearance left offset 0, 0.5 font ",16"
  }
  at(k) = int(word(shown, k))
  plot for [k = 1:words(shown)] for [p = 1:3] "section" \
      using (strcol(4) eq kind[at(k)] && $3 == p - 1 ? $1 : NaN):2 with points pointtype mark[p] pointsize size_of[p] \
      linecolor rgb colour[at(k)] notitle, \
    for [k = 1:words(shown)] NaN with points pointtype 7 pointsize 1.6 linecolor rgb colour[at(k)] title legend[at(k)], \
    for [p = 1:3] NaN with points pointtype mark[p] pointsize 1.2 linecolor rgb "#444444" \
      title (several && is_shown(pass[p]) ? pass_legend[p] : "")
  unset label
  unset arrow 1

  eval no_rpm
  set tmargin at screen 0.39
  set bmargin at screen 0.10
  set yrange [0:*]
  set format x "% h"
  set xlabel x_label noenhanced
  set label 3 "largest displacement (" . ARG8 . ")" at screen 0.015, 0.245 center rotate by 90
  set key at screen 0.765, graph 1
  plot for [p = 1:3] "peaks" using ($3 == p - 1 ? $1 : NaN):2 with linespoints pointtype mark[p] \
      pointsize size_of[p] linecolor rgb pass_colour[p] linewidth 1.2 title (is_shown(pass[p]) ? pass_legend[p] : "")
  unset multiplot
  unset output
}
