# Draws the traces that `rubplot trace` lays out, one row of panels per trace: time history, orbit, full spectrum.
# Arguments: HEADING ROWS BYLINE
# Files: rows.gp (assignments) and for each row ROW.history, .orbit, .section, .spectrum, .labels in SI units;
# the lengths among the assignments are in the row's unit, of which there are per_metre[row] in a metre.

heading = ARG1
rows = int(ARG2)
load "rows.gp"

# Colours: Paul Tol's "muted" scheme, made for colour-blind readers.
rotor = "#332288"
wall = "#CC6677"
point = "#882255"
kick = "#DDCC77"
probe = "#117733"
away = "#44AA99"
solid = "#E4E4E4"

# Pixels. The orbit's panel is square.
width = 2000
title_px = 120
row_px = 590
panel_px = 440
bottom_px = 100
height = title_px + rows * row_px + (ARG3 eq "" ? 0 : 28)  # a line for the note below

x_at(px) = real(px) / width
y_at(row, px) = 1 - real(title_px + row * row_px - bottom_px - px) / height
file(row, name) = sprintf("%d.%s", row, name)
probe_file(row, what) = file(row, probed[row] ? "probe_" . what : what)  # gnuplot reads the body of an empty loop, too
at(list, k) = k > words(list) ? NaN : real(word(list, k))  # gnuplot reads the body of an empty loop, too
largest(a, b) = a > b ? a : b

# A round number that divides `range` into at most `count` parts.
round_up(x) = x <= 1 ? 1 : x <= 2 ? 2 : x <= 5 ? 5 : 10
power(x) = 10.0**floor(log10(x))
step(range, count) = power(1.0 * range / count) * round_up(1.0 * range / count / power(1.0 * range / count))

# The motion before: rest, or the quiet whirl before the kick, continued from the state at its start; only known where
# nothing shifts its mean.
angle(row, t) = 2 * pi * speed_hz[row] * t
before_kick(row, t) = t > 0 || from[row] > 0 || in_state[row] ? NaN : at_rest[row] ? start_y_m[row] : gravity[row] != 0 ? NaN : \
  start_y_m[row] * cos(angle(row, t)) + start_vy_m_per_s[row] / (2 * pi * speed_hz[row]) * sin(angle(row, t))

# Where the rotor is at a stop elsewhere along the shaft: short of the wall by the gap.
casing_at(row, k) = at(elsewhere[row], k + 1) > 0 ? column(int(at(elsewhere[row], k + 1))) * per_metre[row] : 0
rest_at(row, k) = at(elsewhere[row], k + 2)
at_stop(row, k) = k > words(elsewhere[row]) ? NaN : \
  rest_at(row, k) + casing_at(row, k) - sgn(rest_at(row, k)) * column(int(at(elsewhere[row], k))) * per_metre[row]

# A flat wall of normal (nx, ny) at distance c reaches from low to high above x, in a picture of +-reach.
inside(y) = y > reach ? reach : y < -reach ? -reach : y
low(x, nx, ny, c) = abs(ny) < 1e-6 ? (nx * x < c ? NaN : -reach) : ny > 0 ? inside((c - nx * x) / ny) : -reach
high(x, nx, ny, c) = abs(ny) < 1e-6 ? (nx * x < c ? NaN : reach) : ny > 0 ? reach : inside((c - nx * x) / ny)

array walls_reach[rows]  # the far side of the farthest wall that is not too far from the orbit
array orbit_reach[rows]  # how far the orbit goes in x or y
array level_reach[rows]  # likewise of what the time history shows
any_moving_wall = 0
any_kick = 0
any_probe = 0
any_elsewhere = 0
highest_order = 2
do for [row = 1:rows] {
  if (highest[row] > highest_order) { highest_order = highest[row] }
  # A far wall does not shrink the orbit to a point.
  stats file(row, "orbit") using (largest(abs($1), abs($2)) * per_metre[row]) name "O" nooutput
  orbit_reach[row] = O_max
  far = 6 * O_max
  if (far == 0) { far = 1e30 }
  walls_reach[row] = 0
  do for [k = 3:words(walls[row]):3] {
    if (at(walls[row], k) < far) { walls_reach[row] = largest(walls_reach[row], at(walls[row], k)) }
  }
  do for [k = 3:words(rings[row]):3] {
    offset = largest(abs(at(rings[row], k - 2)), abs(at(rings[row], k - 1)))
    if (at(rings[row], k) < far) { walls_reach[row] = largest(walls_reach[row], at(rings[row], k) + offset) }
  }
  level_reach[row] = 0
  do for [k = 1:words(levels[row])] {
    if (abs(at(levels[row], k)) < far) { level_reach[row] = largest(level_reach[row], abs(at(levels[row], k))) }
  }
  if (words(elsewhere[row])) { any_elsewhere = 1 }
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

do for [format in formats] {
  eval canvas(format, width, height, 'DejaVu Sans,20', 1.5)
  set multiplot
  @clear_panel
  set border 0
  unset xtics
  unset ytics
  set label 1 heading at screen 0.5, 1 - 30.0 / height center font ":Bold,24" noenhanced
  set label 11 ARG3 at screen 0.995, 12.0 / height right font ",13" noenhanced

  # Legend, across the whole picture; only what some row shows.
  at_px = 0.5 * (width - 940 - (any_moving_wall ? 300 : 0) - (any_elsewhere ? 330 : 0) - (any_kick ? 130 : 0) - (any_probe ? 240 : 0))
  at_y = 1 - 78.0 / height
  set arrow from screen x_at(at_px), at_y to screen x_at(at_px + 60), at_y nohead linecolor rgb rotor linewidth 2
  set label 2 "rotor" at screen x_at(at_px + 72), at_y left
  at_px = at_px + 210
  if (any_elsewhere) {
    set arrow from screen x_at(at_px), at_y to screen x_at(at_px + 60), at_y nohead linecolor rgb away linewidth 1.5 dashtype 4
    set label 10 "rotor at the stop" at screen x_at(at_px + 72), at_y left
    at_px = at_px + 330
  }
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
    stats file(row, "history") using ($3 * per_metre[row]) name "H" nooutput
    reach = largest(level_reach[row], largest(H_max, -H_min))
    do for [k = 1:words(elsewhere[row]):3] {
      stats file(row, "history") using (at_stop(row, k)) name "H" nooutput
      reach = largest(reach, largest(H_max, -H_min))
    }
    period = 1.0 / speed_hz[row]
    origin = from[row] * period
    begin = from[row] > 0 || in_state[row] ? 0 : -4 * period
    end = to[row] * period - origin
    per_second = end > 2 ? 1 : 1e3
    reach = reach > 0 ? 1.15 * reach : 1
    set lmargin at screen x_at(120)
    set rmargin at screen x_at(850)
    set bmargin at screen y_at(row, 0)
    set tmargin at screen y_at(row, panel_px)
    set xrange [begin * per_second:end * per_second]
    set yrange [-reach:reach]
    set xtics step(end - begin, 8) * per_second
    set ytics step(2 * reach, 7)
    set xlabel (from[row] > 0 ? sprintf("time after revolution %d ", from[row]) : "time ") . \
      (per_second == 1 ? "(s)" : "(ms)") offset 0, 0.3
    set label 1 sprintf("y (%s)", unit[row]) at screen x_at(25), y_at(row, 0.5 * panel_px) center rotate by 90
    set label 2 row_title[row] at screen x_at(120), y_at(row, panel_px + 30) left font ":Bold"
    if (kick_s[row] > 0 && from[row] == 0) {
      set object rectangle from 0, graph 0 to kick_s[row] * per_second, graph 1 back \
        fillcolor rgb kick fillstyle solid 0.6 noborder
    }
    do for [k = 1:words(levels[row])] {
      c = at(levels[row], k)
      if (abs(c) <= reach) { set arrow from graph 0, first c to graph 1, first c nohead back dashtype 2 linecolor rgb "black" }
    }
    set samples 1000
    plot for [k = 1:words(moving_walls[row]):2] file(row, "history") \
        using (($1 - origin) * per_second):(column(int(at(moving_walls[row], k))) * per_metre[row] + at(moving_walls[row], k + 1)) \
        with lines linecolor rgb wall linewidth 2.5 notitle, \
      [begin * per_second:(begin < 0 ? 0 : end * per_second)] before_kick(row, x / per_second) * per_metre[row] \
        with lines linecolor rgb rotor linewidth 1.2 notitle, \
      file(row, "history") using (($1 - origin) * per_second):($3 * per_metre[row]) \
        with lines linecolor rgb rotor linewidth 1.2 notitle, \
      for [k = 1:words(elsewhere[row]):3] file(row, "history") using (($1 - origin) * per_second):(at_stop(row, k)) \
        with lines linecolor rgb away linewidth 1.5 dashtype 4 notitle, \
      for [k = 1:probed[row]] probe_file(row, "history") using (($1 - origin) * per_second):($2 * per_metre[row]) \
        with points pointtype 6 pointsize 0.8 linecolor rgb probe notitle

    # Orbit.
    @clear_panel
    reach = largest(walls_reach[row], orbit_reach[row])
    reach = reach > 0 ? 1.2 * reach : 1
    set lmargin at screen x_at(985)
    set rmargin at screen x_at(985 + panel_px)
    set xrange [-reach:reach]
    set yrange [-reach:reach]
    set xlabel sprintf("x (%s)", unit[row]) offset 0, 0.3
    set label 1 sprintf("y (%s)", unit[row]) at screen x_at(884), y_at(row, 0.5 * panel_px) center rotate by 90
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
      file(row, "orbit") using ($1 * per_metre[row]):($2 * per_metre[row]) with lines linecolor rgb rotor linewidth 1.2 notitle, \
      for [k = 1:probed[row]] probe_file(row, "orbit") using ($1 * per_metre[row]):($2 * per_metre[row]) \
        with points pointtype 6 pointsize 0.8 linecolor rgb probe notitle, \
      file(row, "section") using ($1 * per_metre[row]):($2 * per_metre[row]) with points pointtype 7 pointsize 1.1 linecolor rgb point notitle

    # Full spectrum.
    @clear_panel
    stats file(row, "spectrum") using ($2 * per_metre[row]) name "S" nooutput
    set lmargin at screen x_at(1572)
    set rmargin at screen x_at(1970)
    set xrange [-highest_order - 0.2:highest_order + 0.2]
    set yrange [0:S_max > 0 ? 1.4 * S_max : 1]
    set xlabel "order (× shaft speed)" offset 0, 0.3
    set label 4 "backward" at graph 0.03, 0.94 left
    set label 5 "forward" at graph 0.97, 0.94 right
    set label 1 sprintf("amplitude (%s)", unit[row]) at screen x_at(1449), y_at(row, 0.5 * panel_px) center rotate by 90
    order_step = highest_order > 4 ? 2 : 1
    set xtics order_step
    set mxtics order_step * (order[row] > 1 ? order[row] : 1)
    set ytics step(S_max > 0 ? 1.4 * S_max : 1, 7)
    plot file(row, "spectrum") using 1:($2 * per_metre[row]) with impulses linecolor rgb rotor linewidth 2 notitle, \
      for [k = 1:probed[row]] probe_file(row, "spectrum") using 1:($2 * per_metre[row] > 0.004 * S_max ? $2 * per_metre[row] : NaN) \
        with points pointtype 6 pointsize 0.8 linecolor rgb probe notitle, \
      file(row, "labels") using 1:($2 * per_metre[row]):3 \
        with labels rotate by 90 left offset 0, 0.4 font ",16" notitle
    @clear_panel
  }
  unset multiplot
}
