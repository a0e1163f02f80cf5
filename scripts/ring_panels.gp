# Draws the panels that ring_figure.sh lays out: real parts above, frequencies below, onsets as vertical lines.
# gnuplot -c ring_panels.gp DIRECTORY OUTPUT_BASENAME HEADING PANELS
# DIRECTORY holds panels.gp (title, from, to, limit) and for each panel NAME.curve (rpm, real, imaginary) and onsets.

directory = ARG1
output = ARG2
heading = ARG3
panels = int(ARG4)
array title[panels]
array from[panels]
array to[panels]
array limit[panels]
load directory . "/panels.gp"

# Colours: Paul Tol's "muted" scheme, made for colour-blind readers.
array name[7] = ["ring forward", "ring backward", "load 0 flexural", "load 1 flexural", "load 2 flexural", "load 0 radial", ""]
array colour[6] = ["#CC6677", "#332288", "#117733", "#DDAA33", "#88CCEE", "#999933"]
divergence = "#AA4499"
flutter = "#999999"
coupling = "#44AA99"

file(p, k) = directory . "/" . p . "/" . name[k] . ".curve"
drawn(p, k) = int(system("test -s '" . file(p, k) . "' && echo 1 || echo 0"))

columns = panels == 1 ? 1 : 2
rows = int((panels + columns - 1) / columns)
width = columns == 1 ? 1300 : 2000
title_px = 120
row_px = 830
height = title_px + rows * row_px
left(c) = (real(c) + (columns == 1 ? 0.095 : 0.14)) / columns
right(c) = (real(c) + 0.965) / columns
above(r, px) = 1 - real(title_px + r * row_px + px) / height
round_up(x) = x <= 1 ? 1 : x <= 2 ? 2 : x <= 5 ? 5 : 10
power(x) = 10.0**floor(log10(x))
step(range, count) = power(1.0 * range / count) * round_up(1.0 * range / count / power(1.0 * range / count))

set terminal pngcairo size width, height font "DejaVu Sans,18" linewidth 1.5
set encoding utf8
set minussign
set output output . ".png"
set multiplot
set label 1 heading at screen 0.5, 1 - 30.0 / height center font ":Bold,22"
unset key
set border 0
unset xtics
unset ytics

# Legend: the modes of any panel, then the lines.
shown = ""
do for [k = 1:6] {
  do for [p = 1:panels] { if (drawn(p, k) && !strstrt(shown, sprintf(" %d ", k))) { shown = shown . sprintf(" %d ", k) } }
}
entries = words(shown) + 3
array lines[3] = ["divergence", "flutter", "coupling (µ = 0)"]
array line_colour[3] = [divergence, flutter, coupling]
entry = 0.97 / entries < 0.135 ? 0.97 / entries : 0.135
x_of(e) = 0.5 + (e - 1 - 0.5 * entries) * entry
do for [e = 1:words(shown)] {
  k = int(word(shown, e))
  set arrow from screen x_of(e), 1 - 80.0 / height to screen x_of(e) + 0.02, 1 - 80.0 / height nohead linecolor rgb colour[k] linewidth 4
  set label name[k] at screen x_of(e) + 0.025, 1 - 80.0 / height left font columns == 1 ? ",13" : ",15"
}
do for [j = 1:3] {
  e = words(shown) + j
  set arrow from screen x_of(e), 1 - 80.0 / height to screen x_of(e) + 0.02, 1 - 80.0 / height nohead dashtype 2 linecolor rgb line_colour[j] linewidth 2
  set label lines[j] at screen x_of(e) + 0.025, 1 - 80.0 / height left font columns == 1 ? ",13" : ",15"
}
plot [0:1] [0:1] NaN notitle

do for [p = 1:panels] {
  r = int((p - 1) / columns)
  c = (p - 1) % columns
  set autoscale
  list = ""
  highest = 0
  reach = 0
  do for [k = 1:6] {
    if (drawn(p, k)) {
      list = list . sprintf("%d ", k)
      stats file(p, k) using 2:3 name "S" nooutput
      if (S_max_y > highest) { highest = S_max_y }
      if (S_max_x > reach) { reach = S_max_x }
      if (-S_min_x > reach) { reach = -S_min_x }
    }
  }
  bound = limit[p] > 0 ? limit[p] : 1.1 * reach
  unset label
  unset arrow
  set border 31
  set xrange [from[p]:to[p]]
  set lmargin at screen left(c)
  set rmargin at screen right(c)
  set xtics step(to[p] - from[p], 7) out nomirror
  events = directory . "/" . p . "/onsets"
  onsets = system("cat '" . events . "'")
  do for [i = 1:words(onsets):2] {
    kind = word(onsets, i + 1)
    hue = kind[1:3] eq "div" ? divergence : kind[1:3] eq "cou" ? coupling : flutter
    set arrow from real(word(onsets, i)), graph 0 to real(word(onsets, i)), graph 1 nohead back dashtype 2 linecolor rgb hue linewidth 1.2
  }
  # Real parts.
  set tmargin at screen above(r, 40)
  set bmargin at screen above(r, 370)
  set yrange [-bound:bound]
  set ytics step(2 * bound, 6) out nomirror
  set format x ""
  unset xlabel
  set label 2 title[p] at graph 0, 1.06 left font ":Bold"
  set ylabel "real part (1/s)" offset 1
  set arrow from graph 0, first 0 to graph 1, first 0 nohead back linecolor rgb "black" linewidth 0.8
  plot for [i = 1:words(list)] file(p, int(word(list, i))) using 1:2 with points pointtype 7 pointsize 0.25 \
    linecolor rgb colour[int(word(list, i))] notitle
  # Frequencies.
  unset label 2
  set tmargin at screen above(r, 400)
  set bmargin at screen above(r, 740)
  set yrange [0:1.05 * highest]
  set ytics step(1.05 * highest, 6)
  set format x "%g"
  set xlabel "speed (rpm)" offset 0, 0.4
  set ylabel "frequency (rad/s)" offset 1
  plot for [i = 1:words(list)] file(p, int(word(list, i))) using 1:3 with points pointtype 7 pointsize 0.25 \
    linecolor rgb colour[int(word(list, i))] notitle
}
unset multiplot
