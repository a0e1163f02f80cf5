# Draws the fit that pictures/fit.py lays out.
# Arguments: HEADING COLUMNS
# Files: panels.gp (title, axis, unit, left_unit, kind, sensors, nothing_left and left_step of each column; the sentences found_N),
# upper_C_N and lower_C_N (place, measured, modelled, of 1X what is left) of sensor N in column C.

heading = ARG1
columns = int(ARG2)
load "panels.gp"
of(name, column) = value(sprintf("%s_%d", name, column))
upper(column, i) = sprintf("upper_%d_%d", column, i)
lower(column, i) = sprintf("lower_%d_%d", column, i)
# Paul Tol's "muted" scheme, sensor by sensor.
array colours[4] = ["#332288", "#CC6677", "#117733", "#DDCC77"]
# Sentences below each other, two beside each other where the page is wide.
beside = columns == 1 ? 1 : 2
rows = (found + beside - 1) / beside

do for [format in formats] {
  eval canvas(format, columns == 1 ? 1100 : columns == 2 ? 1600 : 2100, 900 + 32 * rows, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  high = 900.0 + 32 * rows
  set label 1 heading at screen 0.5, 1 - 26 / high center font ":Bold,22" noenhanced
  do for [i = 0:found - 1] {
    set label 100 + i value(sprintf("found_%d", i)) font ",17" noenhanced \
      at screen (columns == 1 ? 0.08 : 0.05) + 0.48 * (i % beside), (32 * (rows - i / beside) - 8) / high left
  }
  set tics nomirror out
  set grid linecolor rgb "#E4E4E4"
  do for [c = 0:columns - 1] {
    set lmargin at screen (c + (columns == 1 ? 0.13 : 0.21)) / columns
    set rmargin at screen (c + 0.97) / columns
    ring = of("kind", c) eq "ring_down"
    rub = of("kind", c) eq "rub"
    last = of("sensors", c) - 1
    # Steady speeds are few.
    dot = of("kind", c) eq "steady" ? 1.0 : 0.45

    # Under the key there are revolutions per minute.
    eval rpm_above("" . of("axis", c))
    set tmargin at screen 1 - (strlen(rpm_above("" . of("axis", c))) ? 176 : 130) / high
    set bmargin at screen 1 - 440 / high
    unset xlabel
    set format x ""
    set xrange [*:*]
    set yrange [*:*]
    set ytics autofreq
    if (!ring) { set yrange [0:*] }
    # Lines of a rub that tell of its stop are a thousandth of the largest.
    if (rub) { set offsets 0.2, 0.2, 0, 0; set yrange [*:*]; set logscale y; set format y "10^{%T}" }
    set label 2 sprintf(ring ? "reading (%s)" : "amplitude (%s)", of("unit", c)) center rotate by 90 \
      at screen (c + (columns == 1 ? 0.02 : 0.025)) / columns, screen 1 - 285 / high
    set label 3 "" . of("title", c) at graph 0.5, screen 1 - 72 / high center noenhanced
    set key at graph 0.5, screen 1 - 106 / high center center horizontal samplen 1.5 noenhanced font ",16"
    if (rub) {
      plot for [i = 0:last] upper(c, i) using ($1 - 0.02):2 with impulses linewidth 4 linecolor rgb colours[1] \
          title (i ? "" : "measured"), \
        for [i = 0:last] upper(c, i) using ($1 + 0.02):3 with impulses linewidth 4 linecolor rgb colours[2] \
          title (i ? "" : "model")
    } else {
      plot for [i = 0:last] upper(c, i) using 1:2 with points pointtype 7 pointsize dot linecolor rgb colours[i + 1] \
          title value(sprintf("name_%d_%d", c, i)), \
        for [i = 0:last] upper(c, i) using 1:3 with lines linewidth 1.5 linecolor rgb colours[i + 1] notitle, \
        NaN with lines linewidth 1.5 linecolor rgb "#666666" title "model"
    }
    unset logscale y
    set format y "% h"
    unset label 3
    unset key
    unset label 1
    do for [i = 0:found - 1] { unset label 100 + i }

    eval no_rpm
    set tmargin at screen 1 - 474 / high
    # Below the phases of 1X stands what is left of it.
    below = !ring && !rub
    set bmargin at screen 1 - (below ? 636.0 : 770.0) / high
    set xlabel (below ? "" : "" . of("axis", c))
    set format x (below ? "" : "% h")
    set yrange [*:*]
    set label 2 (ring ? sprintf("left (%s)", of("left_unit", c)) : "phase (deg)") center rotate by 90 \
      at screen (c + (columns == 1 ? 0.02 : 0.025)) / columns, screen 1 - (below ? 555.0 : 615.0) / high
    if (!ring) { set ytics 90 }
    if (of("nothing_left", c)) { set yrange [-1:1] }
    plot for [i = 0:last] lower(c, i) using 1:2 with points pointtype 7 pointsize (rub ? 1.2 : dot) \
        linecolor rgb colours[i + 1], \
      for [i = 0:last] lower(c, i) using 1:3 with points pointtype 6 pointsize (rub ? 1.6 : 0) linewidth 2 \
        linecolor rgb colours[rub ? 2 : i + 1], \
      for [i = 0:last] lower(c, i) using 1:(rub ? NaN : $3) with lines linewidth 1.5 linecolor rgb colours[i + 1]
    set offsets 0, 0, 0, 0
    if (below) {
      set tmargin at screen 1 - 666 / high
      set bmargin at screen 1 - 770 / high
      set xlabel "" . of("axis", c)
      set format x "% h"
      set yrange [0:*]
      set ytics of("left_step", c)
      set label 2 sprintf("left (%s)", of("left_unit", c)) center rotate by 90 \
        at screen (c + (columns == 1 ? 0.02 : 0.025)) / columns, screen 1 - 718 / high
      plot for [i = 0:last] lower(c, i) using 1:4 with points pointtype 7 pointsize dot linecolor rgb colours[i + 1]
    }
  }
  unset multiplot
  unset output
}
