# Draws the Campbell diagram that pictures/campbell.py lays out.
# Arguments: HEADING SHAPES BYLINE
# Files: curves, critical, shapes, shaft and labels.gp; SHAPES: how many mode shapes there are.

heading = ARG1
shapes = int(ARG2)

# Colours: Paul Tol's "muted" scheme, made for colour-blind readers.
array colour[3] = ["#332288", "#CC6677", "#999933"]
array direction[3] = ["forward whirl", "backward whirl", "neither way"]
array dash[3] = [1, 2, 4]
array shape_colour[4] = ["#332288", "#CC6677", "#117733", "#DDAA33"]
turning = "#777777"

# Here, while no axis has a range: of what lies outside the range of an axis, stats sees nothing.
stats "curves" using 1 name "C" nooutput
if (shapes) { stats "shapes" index 0 using 1 name "P" nooutput }
right = shapes ? 0.56 : 0.95

do for [format in formats] {
  eval canvas(format, 2000, 1000, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set label 1000 heading at screen 0.5, 0.972 center font ":Bold,24" noenhanced
  set label 1003 ARG3 at screen 0.995, 0.015 right font ",13" noenhanced

  set style textbox opaque noborder fillcolor rgb "white" margins 0.3, 0.1
  load "labels.gp"
  set lmargin at screen 0.075
  set rmargin at screen right
  set bmargin at screen (ARG3 eq "" ? 0.12 : 0.145)
  set tmargin at screen 0.81
  set border 31 linewidth 1
  set tics nomirror out
  set xrange [C_min:fastest * per_hz]
  set yrange [0:top]
  speed_label = per_hz == 1 ? "shaft speed (Hz)" : "shaft speed (rpm)"
  eval rpm_above(speed_label)
  set xlabel speed_label . (any_locks ? ", ◇ lock speed" : "")
  # Not as labels of the axes: beside a fixed margin these may come over the numbers.
  set label 1004 "whirl frequency (Hz)" at screen 0.013, 0.49 center rotate by 90
  set key at screen 0.075, screen 0.945 left top horizontal Left reverse noopaque samplen 2.5 maxrows 1
  set label 1001 "1X" at first name_of_1x * per_hz, first name_of_1x + above_line right textcolor rgb turning
  if (name_of_2x > 0) {
    set label 1002 "2X" at first name_of_2x * per_hz, first 2 * name_of_2x + above_line right textcolor rgb turning
  }
  plot x / per_hz with lines linecolor rgb turning dashtype 3 linewidth 1.5 notitle, \
    2 * x / per_hz with lines linecolor rgb turning dashtype 3 linewidth 0.8 notitle, \
    for [k = 1:(any_mixed ? 3 : 2)] "curves" using 1:($3 == k - 1 ? $2 : NaN) with lines \
      linecolor rgb colour[k] dashtype dash[k] linewidth 2 title direction[k], \
    "critical" using ($1 * per_hz):1 with points pointtype 7 pointsize 1.3 \
      linecolor rgb "black" title (any_critical ? "critical speed" : "")
  unset label
  eval no_rpm

  if (shapes) {
    set lmargin at screen 0.68
    set rmargin at screen 0.98
    margin = 0.03 * (P_max - P_min)
    set xrange [P_min - margin:P_max + margin]
    set yrange [-1.25:1.55]
    set xlabel "place along the shaft (mm)"
    # In parentheses it would be a list of one tick.
    step = P_max - P_min > 6000 ? 2000 : 500
    if (P_max - P_min > 1200) { set xtics step }
    set label 5 "deflection / largest" at screen 0.628, 0.49 center rotate by 90
    set key at graph 0.5, graph 0.99 center top Left reverse opaque samplen 2 spacing 1.2 maxrows 2 font ",16"
    set arrow 1 from first P_min, first 0 to first P_max, first 0 nohead linewidth 3 linecolor rgb "#AAAAAA" back
    set label 4 "disc ■, support ▲, stop ✕" at graph 0.02, graph 0.03 left font ",16"
    plot "shaft" using 1:($2 == 0 ? 0 : NaN) with points pointtype 5 pointsize 2.6 linecolor rgb "#888888" notitle, \
      "shaft" using 1:($2 == 1 ? -0.07 : NaN) with points pointtype 9 pointsize 2.2 linecolor rgb "#888888" notitle, \
      "shaft" using 1:($2 == 2 ? 0 : NaN) with points pointtype 2 pointsize 2 linewidth 2 linecolor rgb "black" notitle, \
      for [k = 1:shapes] "shapes" index (k - 1) using 1:2 with lines linewidth 2.5 \
        linecolor rgb shape_colour[k] title columnheader(1)
    unset arrow 1
    unset label
  }
  unset multiplot
  unset output
}
