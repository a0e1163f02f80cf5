# Draws the traces that trace.sh lays out, one row of panels per trace: time history, orbit, full spectrum.
# gnuplot -c trace.gp DIRECTORY OUTPUT_BASENAME HEADING ROWS
# DIRECTORY holds rows.gp (assignments) and for each row ROW.history, .orbit, .section, .spectrum, .labels in SI units.

directory = ARG1
output = ARG2
heading = ARG3
rows = int(ARG4)
load directory . "/rows.gp"

# Colours: Paul Tol's "muted" scheme, made for colour-blind readers.
rotor = "#332288"
wall = "#CC6677"
point = "#882255"
kick = "#DDCC77"
probe = "#117733"
solid = "#E4E4E4"

# Pixels. The orbit's panel is square.
width = 2000
title_px = 120
row_px = 590
panel_px = 440
bottom_px = 100
height = title_px + rows * row_px

x_at(px) = real(px) / width
y_at(row, px) = 1 - real(title_px + row * row_px - bottom_px - px) / height
file(row, name) = sprintf("%s/%d.%s", directory, row, name)
probe_file(row, what) = file(row, probed[row] ? "probe_" . what : what)  # gnuplot reads the body of an empty loop, too
at(list, k) = k > words(list) ? NaN : real(word(list, k))  # gnuplot reads the body of an empty loop, too
largest(a, b) = a > b ? a : b

# A round number that divides `range` into at most `count` parts.
round_up(x) = x <= 1 ? 1 : x <= 2 ? 2 : x <= 5 ? 5 : 10
power(x) = 10.0**floor(log10(x))
step(range, count) = power(1.0 * range / count) * round_up(1.0 * range / count / power(1.0 * range / count))

# What was before: rest, or the quiet whirl before the kick, continued from the state at its start; only known where
# nothing shifts its mean.
angle(row, t) = 2 * pi * speed_hz[row] * t
before_kick(row, t) = t > 0 || from[row] > 0 ? NaN : at_rest[row] ? start_y_m[row] : gravity[row] != 0 ? NaN : \
  start_y_m[row] * cos(angle(row, t)) + start_vy_m_per_s[row] / (2 * pi * speed_hz[row]) * sin(angle(row, t))

# A flat wall of normal (nx, ny) at distance c reaches from low to high above x, in a picture of +-reach.
inside(y) = y > reach ? reach : y < -reach ? -reach : y
low(x, nx, ny, c) = abs(ny) < 1e-6 ? (nx * x < c ? NaN : -reach) : ny > 0 ? inside((c - nx * x) / ny) : -reach
high(x, nx, ny, c) = abs(ny) < 1e-6 ? (nx * x < c ? NaN : reach) : ny > 0 ? reach : inside((c - nx * x) / ny)

array walls_reach[rows]  # the far side of the farthest wall, in mm
any_moving_wall = 0
any_kick = 0
any_probe = 0
highest = 2
do for [row = 1:rows] {
  # The spectra go on to the last line above 1 % of the largest in any row.
  stats file(row, "spectrum") using 1:2 name "S" nooutput
  stats file(row, "spectrum") using ($2 > 0.01 * S_max_y ? abs($1) : NaN) name "L" nooutput
  if (ceil(L_max) > highest) { highest = ceil(L_max) }
  walls_reach[row] = 0
  do for [k = 3:words(walls[row]):3] { walls_reach[row] = largest(walls_reach[row], at(walls[row], k)) }
  do for [k = 3:words(rings[row]):3] {
    offset = largest(abs(at(rings[row], k - 2)), abs(at(rings[row], k - 1)))
    walls_reach[row] = largest(walls_reach[row], at(rings[row], k) + offset)
  }
  if (words(moving_walls[row])) { any_moving_wall = 1 }
  if (probed[row]) { any_probe = 1 }
  if (kick_s[row] > 0 && from[row] == 0) { any_kick = 1 }
}

set terminal unknown
set encoding utf8
set minussign
set macros
clear_panel = "unset label; unset object; unset arrow; unset key; unset xlabel; unset mxtics; set autoscale; \
  set border 31 linewidth 1; set xtics nomirror out; set ytics nomirror out"

do for [format in "png svg"] {
  if (format eq "png") {
    set terminal pngcairo size width, height font "DejaVu Sans,20" linewidth 1.5
  } else {
    set terminal svg size width, height font "DejaVu Sans,20" linewidth 1.5
  }
  set output output . "." . format
  set multiplot
  @clear_panel
  set border 0
  unset xtics
  unset ytics
  set label 1 heading at screen 0.5, 1 - 30.0 / height center font ":Bold,24"

  # Legend, across the whole picture; only what some row shows.
  at_px = 0.5 * (width - 940 - (any_moving_wall ? 300 : 0) - (any_kick ? 130 : 0) - (any_probe ? 240 : 0))
  at_y = 1 - 78.0 / height
  set arrow from screen x_at(at_px), at_y to screen x_at(at_px + 60), at_y nohead linecolor rgb rotor linewidth 2
  set label 2 "rotor" at screen x_at(at_px + 72), at_y left
  at_px = at_px + 210
  if (any_moving_wall) {
    set arrow from screen x_at(at_px), at_y to screen x_at(at_px + 60), at_y nohead linecolor rgb wall linewidth 3
    set label 3 "moving wall" at screen x_at(at_px + 72), at_y left
    at_px = at_px + 300
  }
  set arrow from screen x_at(at_px), at_y to screen x_at(at_px + 60), at_y nohead dashtype 2 linecolor rgb "black"
  set label 4 "clearance at rest" at screen x_at(at_px + 72), at_y left
  at_px = at_px + 370
  set label 5 "" at screen x_at(at_px), at_y point pointtype 7 pointsize 1.1 linecolor rgb point
  set label 6 "once per revolution" at screen x_at(at_px + 20), at_y left
  at_px = at_px + 360
  if (any_probe) {
    set label 8 "" at screen x_at(at_px), at_y point pointtype 6 pointsize 0.8 linecolor rgb probe
    set label 9 "probes read" at screen x_at(at_px + 20), at_y left
    at_px = at_px + 240
  }
  if (any_kick) {
    set object rectangle from screen x_at(at_px), at_y - 12.0 / height \
      to screen x_at(at_px + 40), at_y + 12.0 / height fillcolor rgb kick fillstyle solid 0.6 noborder
    set label 7 "kick" at screen x_at(at_px + 52), at_y left
  }
  plot [0:1] [0:1] NaN notitle
  @clear_panel

  do for [row = 1:rows] {
    # Time history.
    stats file(row, "history") using 1:($3 * 1e3) name "H" nooutput
    period = 1.0 / speed_hz[row]
    origin = from[row] * period
    begin = from[row] > 0 ? 0 : -4 * period
    end = to[row] * period - origin
    unit = end > 2 ? 1 : 1e3
    reach = 1.15 * largest(walls_reach[row], largest(H_max_y, -H_min_y))
    set lmargin at screen x_at(120)
    set rmargin at screen x_at(850)
    set bmargin at screen y_at(row, 0)
    set tmargin at screen y_at(row, panel_px)
    set xrange [begin * unit:end * unit]
    set yrange [-reach:reach]
    set xtics step(end - begin, 8) * unit
    set ytics step(2 * reach, 7)
    set xlabel (from[row] > 0 ? sprintf("time after revolution %d ", from[row]) : "time ") . \
      (unit == 1 ? "(s)" : "(ms)") offset 0, 0.3
    set label 1 "y (mm)" at screen x_at(25), y_at(row, 0.5 * panel_px) center rotate by 90
    set label 2 row_title[row] at screen x_at(120), y_at(row, panel_px + 30) left font ":Bold"
    if (kick_s[row] > 0 && from[row] == 0) {
      set object rectangle from 0, graph 0 to kick_s[row] * unit, graph 1 back \
        fillcolor rgb kick fillstyle solid 0.6 noborder
    }
    do for [k = 1:words(walls[row]):3] {
      if (abs(at(walls[row], k)) < 1e-9) {
        c = at(walls[row], k + 1) * at(walls[row], k + 2)
        set arrow from graph 0, first c to graph 1, first c nohead back dashtype 2 linecolor rgb "black"
      }
    }
    do for [k = 1:words(rings[row]):3] {
      do for [s = -1:1:2] {
        c = at(rings[row], k + 1) + s * at(rings[row], k + 2)
        set arrow from graph 0, first c to graph 1, first c nohead back dashtype 2 linecolor rgb "black"
      }
    }
    set samples 1000
    plot for [k = 1:words(moving_walls[row]):2] file(row, "history") \
        using (($1 - origin) * unit):(column(int(at(moving_walls[row], k))) * 1e3 + at(moving_walls[row], k + 1)) \
        with lines linecolor rgb wall linewidth 2.5 notitle, \
      [begin * unit:(begin < 0 ? 0 : end * unit)] before_kick(row, x / unit) * 1e3 \
        with lines linecolor rgb rotor linewidth 1.2 notitle, \
      file(row, "history") using (($1 - origin) * unit):($3 * 1e3) \
        with lines linecolor rgb rotor linewidth 1.2 notitle, \
      for [k = 1:probed[row]] probe_file(row, "history") using (($1 - origin) * unit):($2 * 1e3) \
        with points pointtype 6 pointsize 0.8 linecolor rgb probe notitle

    # Orbit.
    @clear_panel
    stats file(row, "orbit") using ($1 * 1e3):($2 * 1e3) name "O" nooutput
    reach = 1.2 * largest(walls_reach[row], largest(largest(O_max_x, -O_min_x), largest(O_max_y, -O_min_y)))
    set lmargin at screen x_at(985)
    set rmargin at screen x_at(985 + panel_px)
    set xrange [-reach:reach]
    set yrange [-reach:reach]
    set xlabel "x (mm)" offset 0, 0.3
    set label 1 "y (mm)" at screen x_at(884), y_at(row, 0.5 * panel_px) center rotate by 90
    set xtics step(2 * reach, 7)
    set ytics step(2 * reach, 7)
    do for [k = 1:words(rings[row]):3] {
      set object rectangle from graph 0, graph 0 to graph 1, graph 1 behind \
        fillcolor rgb solid fillstyle solid 1 noborder
      set object circle at at(rings[row], k), at(rings[row], k + 1) size at(rings[row], k + 2) back \
        fillcolor rgb "white" fillstyle solid 1 border linecolor rgb "black" dashtype 2
    }
    # As many samples as pixels: an oblique wall has no steps.
    plot for [k = 1:words(walls[row]):3] [t = -reach:reach] '+' \
        using (t):(low(t, at(walls[row], k), at(walls[row], k + 1), at(walls[row], k + 2))): \
          (high(t, at(walls[row], k), at(walls[row], k + 1), at(walls[row], k + 2))) \
        with filledcurves linecolor rgb solid fillstyle solid 1 noborder notitle, \
      for [k = 1:words(walls[row]):3] [t = -2 * reach:2 * reach] '+' \
        using (at(walls[row], k) * at(walls[row], k + 2) - t * at(walls[row], k + 1)): \
          (at(walls[row], k + 1) * at(walls[row], k + 2) + t * at(walls[row], k)) \
        with lines dashtype 2 linecolor rgb "black" notitle, \
      file(row, "orbit") using ($1 * 1e3):($2 * 1e3) with lines linecolor rgb rotor linewidth 1.2 notitle, \
      for [k = 1:probed[row]] probe_file(row, "orbit") using ($1 * 1e3):($2 * 1e3) \
        with points pointtype 6 pointsize 0.8 linecolor rgb probe notitle, \
      file(row, "section") using ($1 * 1e3):($2 * 1e3) with points pointtype 7 pointsize 1.1 linecolor rgb point notitle

    # Full spectrum.
    @clear_panel
    stats file(row, "spectrum") using 1:($2 * 1e3) name "S" nooutput
    set lmargin at screen x_at(1550)
    set rmargin at screen x_at(1970)
    set xrange [-highest - 0.2:highest + 0.2]
    set yrange [0:1.4 * S_max_y]
    set xlabel "order (× shaft speed)" offset 0, 0.3
    set label 4 "backward" at graph 0.03, 0.94 left
    set label 5 "forward" at graph 0.97, 0.94 right
    set label 1 "amplitude (mm)" at screen x_at(1449), y_at(row, 0.5 * panel_px) center rotate by 90
    set xtics 1
    set mxtics order[row] > 1 ? order[row] : 1
    set ytics step(1.4 * S_max_y, 7)
    plot file(row, "spectrum") using 1:($2 * 1e3) with impulses linecolor rgb rotor linewidth 2 notitle, \
      for [k = 1:probed[row]] probe_file(row, "spectrum") using 1:($2 > 0.004 * S_max_y * 1e-3 ? $2 * 1e3 : NaN) \
        with points pointtype 6 pointsize 0.8 linecolor rgb probe notitle, \
      file(row, "labels") using 1:($2 * 1e3):3 \
        with labels rotate by 90 left offset 0, 0.4 font ",16" notitle
    @clear_panel
  }
  unset multiplot
}
