# Draws the deflected shape that pictures/deflected_shape.py lays out.
# Arguments: HEADING BYLINE UNIT NOTE
# Files: line, orbits, amplitude, bearings and labels.gp.

do for [format in formats] {
  eval canvas(format, 2000, 1000, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set label 1000 ARG1 at screen 0.5, 0.972 center font ":Bold,24" noenhanced
  set label 1001 ARG4 at screen 0.5, 0.928 center font ",16" noenhanced
  set label 1003 ARG2 at screen 0.995, 0.016 right font ",13" noenhanced
  load "labels.gp"
  set bmargin at screen (ARG2 eq "" ? 0.11 : 0.135)
  if (any_shaft) {
    set lmargin at screen 0.02
    set rmargin at screen 0.6
    set tmargin at screen 0.85
    eval shaft_view
    set xlabel "place along the shaft (mm)"
    step = to - from > 6000 ? 2000 : 500
    if (to - from > 1200) { set xtics step }
    set key at screen 0.31, screen 0.885 center top horizontal samplen 2 maxrows 1
    plot "orbits" using 1:2 with lines linewidth 1.2 linecolor rgb "#88CCEE" title "orbits", \
      "line" using 1:2 with lines linewidth 3 linecolor rgb "#332288" title "shaft at one instant"
    unset label
    unset arrow
    set border 3
    set lmargin at screen 0.705
    set rmargin at screen 0.97
    set xrange [from:to]
    set yrange [0:1.1 * largest]
    set ytics nomirror out
    set label 1004 sprintf("half of the major axis (%s)", ARG3) at screen 0.618, 0.48 center rotate by 90
    set key at screen 0.97, screen 0.885 right top
    plot "amplitude" using 1:2 with lines linewidth 2.5 linecolor rgb "#332288" notitle, \
      "bearings" using 1:(0) with points pointtype 9 pointsize 2.2 linecolor rgb "#117733" title (any_bearings ? "bearing" : "")
  } else {
    set lmargin at screen 0.3
    set rmargin at screen 0.7
    set tmargin at screen 0.84
    set size ratio -1
    set border 3
    set tics nomirror out
    set xrange [-1.2 * largest:1.2 * largest]
    set yrange [-1.2 * largest:1.2 * largest]
    set xlabel sprintf("x (%s)", ARG3)
    set ylabel sprintf("y (%s)", ARG3)
    set key at screen 0.5, screen 0.89 center top
    plot "orbits" using 1:2 with lines linewidth 2 linecolor rgb "#332288" title "orbit of the disc"
  }
  unset multiplot
  unset output
}
