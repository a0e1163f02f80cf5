# Draws the panels that pictures/ring.py lays out: real parts above, frequencies below, onsets as vertical lines.
# Arguments: HEADING PANELS MODES BYLINE
# Files: panels.gp (mode_name; title, from, to, limit, drawn, onsets of each panel; drawn: the numbers of its modes) and of
# each panel and mode curve_PANEL_MODE (rpm, real, imaginary part).

heading = ARG1
panels = int(ARG2)
modes = int(ARG3)
load "panels.gp"

# Colours: Paul Tol's "muted" scheme, made for colour-blind readers.
array colours[9] = ["#CC6677", "#332288", "#117733", "#DDAA33", "#88CCEE", "#999933", "#882255", "#661100", "#777777"]
colour(k) = colours[1 + (k - 1) % 9]
divergence = "#AA4499"
flutter = "#999999"
coupling = "#44AA99"

file(p, k) = sprintf("curve_%d_%d", p, k)
is_drawn(p, k) = strstrt(" " . drawn[p] . " ", sprintf(" %d ", k)) > 0

columns = panels == 1 ? 1 : 2
rows = int((panels + columns - 1) / columns)
width = columns == 1 ? 1300 : 2000
title_px = 120
row_px = 830
height = title_px + rows * row_px + (ARG4 eq "" ? 0 : 28)  # a line for the note below
left(c) = (real(c) + (columns == 1 ? 0.11 : 0.14)) / columns
label_at(c) = left(c) - (columns == 1 ? 0.095 : 0.058)
right(c) = (real(c) + 0.965) / columns
above(r, px) = 1 - real(title_px + r * row_px + px) / height
round_up(x) = x <= 1 ? 1 : x <= 2 ? 2 : x <= 5 ? 5 : 10
power(x) = 10.0**floor(log10(x))
step(range, count) = power(1.0 * range / count) * round_up(1.0 * range / count / power(1.0 * range / count))

do for [format in formats] {
  eval canvas(format, width, height, 'DejaVu Sans,18', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set label 1 heading at screen 0.5, 1 - 30.0 / height center font ":Bold,22" noenhanced
  set label 3 ARG4 at screen 0.995, 12.0 / height right font ",12" noenhanced
  unset key
  set border 0
  unset xtics
  unset ytics

  # Legend: the modes of any panel, then the lines.
  shown = ""
  do for [k = 1:modes] {
    do for [p = 1:panels] { if (is_drawn(p, k) && !strstrt(shown, sprintf(" %d ", k))) { shown = shown . sprintf(" %d ", k) } }
  }
  entries = words(shown) + 3
  array lines[3] = ["divergence", "flutter", "coupling (µ = 0)"]
  array line_colour[3] = [divergence, flutter, coupling]
  entry = 0.97 / entries < 0.135 ? 0.97 / entries : 0.135
  x_of(e) = 0.5 + (e - 1 - 0.5 * entries) * entry
  do for [e = 1:words(shown)] {
    k = int(word(shown, e))
    set arrow from screen x_of(e), 1 - 80.0 / height to screen x_of(e) + 0.02, 1 - 80.0 / height nohead linecolor rgb colour(k) linewidth 4
    set label mode_name[k] at screen x_of(e) + 0.025, 1 - 80.0 / height left font columns == 1 ? ",13" : ",15"
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
    do for [k = 1:modes] {
      if (is_drawn(p, k)) {
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
    do for [i = 1:words(onsets[p]):2] {
      kind = word(onsets[p], i + 1)
      hue = kind[1:3] eq "div" ? divergence : kind[1:3] eq "cou" ? coupling : flutter
      set arrow from real(word(onsets[p], i)), graph 0 to real(word(onsets[p], i)), graph 1 nohead back dashtype 2 linecolor rgb hue linewidth 1.2
    }
    # Real parts.
    set tmargin at screen above(r, 40)
    set bmargin at screen above(r, 370)
    set yrange [-bound:bound]
    set ytics step(2 * bound, 6) out nomirror
    set format x ""
    unset xlabel
    set label 2 title[p] at graph 0, 1.06 left font ":Bold"
    # Not as labels of the axes: beside a fixed margin these may come over the numbers.
    set label 4 "real part (1/s)" at screen label_at(c), above(r, 205) center rotate by 90
    set arrow from graph 0, first 0 to graph 1, first 0 nohead back linecolor rgb "black" linewidth 0.8
    plot for [i = 1:words(list)] file(p, int(word(list, i))) using 1:2 with points pointtype 7 pointsize 0.25 \
      linecolor rgb colour(int(word(list, i))) notitle
    # Frequencies.
    unset label 2
    set tmargin at screen above(r, 400)
    set bmargin at screen above(r, 740)
    set yrange [0:1.05 * highest]
    set ytics step(1.05 * highest, 6)
    set format x "%g"
    set xlabel "speed (rpm)" offset 0, 0.4
    set label 4 "frequency (rad/s)" at screen label_at(c), above(r, 570) center rotate by 90
    plot for [i = 1:words(list)] file(p, int(word(list, i))) using 1:3 with points pointtype 7 pointsize 0.25 \
      linecolor rgb colour(int(word(list, i))) notitle
  }
  unset multiplot
  unset output
}
