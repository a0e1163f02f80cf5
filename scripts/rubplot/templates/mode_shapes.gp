# Draws the mode shapes that pictures/mode_shapes.py lays out.
# Arguments: HEADING BYLINE SHAPES
# Files: line_0, orbits_0, line_1 ... and labels.gp; SHAPES: how many there are.

shapes = int(ARG3)
columns = shapes == 1 ? 1 : 2
lines = (shapes + columns - 1) / columns
high = 150.0 + 480 * lines

do for [format in formats] {
  eval canvas(format, 2000, 150 + 480 * lines, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  load "labels.gp"
  unset key
  step = to - from > 6000 ? 2000 : 500
  do for [k = 0:shapes - 1] {
    if (k == 0) {
      set label 1000 ARG1 at screen 0.5, 1 - 32 / high center font ":Bold,24" noenhanced
      set label 1003 ARG2 at screen 0.995, 15 / high right font ",13" noenhanced
    }
    left = 1.0 * (k % columns) / columns
    top = 1 - 60 / high - (k / columns) * 480 / high
    set label 1001 value(sprintf("name_%d", k)) at screen (left + 0.5 / columns), screen (top - 22 / high) center font ",17" noenhanced
    set lmargin at screen (left + 0.02)
    set rmargin at screen (left + 1.0 / columns - 0.02)
    set tmargin at screen (top - 40 / high)
    set bmargin at screen (top - 420 / high)
    eval shaft_view
    if (to - from > 1200) { set xtics step }
    set xlabel (k >= shapes - columns ? "place along the shaft (mm)" : "")
    plot sprintf("orbits_%d", k) using 1:2 with lines linewidth 1.2 linecolor rgb "#88CCEE", \
      sprintf("line_%d", k) using 1:2 with lines linewidth 3 linecolor rgb "#332288"
    unset label
    unset arrow
  }
  unset multiplot
  unset output
}
