# Draws the undamped critical speed map that pictures/critical_map.py lays out.
# Arguments: HEADING BYLINE SPEED_LABEL CURVES
# Files: modes, curve_0, curve_1 ... and labels.gp; CURVES: how many of bearings there are.

curves = int(ARG4)

# Colours: Paul Tol's "muted" scheme, made for colour-blind readers.
array colour[6] = ["#CC6677", "#117733", "#DDAA33", "#AA4499", "#88CCEE", "#999933"]

do for [format in formats] {
  eval canvas(format, 2000, 1100, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set label 1000 ARG1 at screen 0.5, 0.972 center font ":Bold,24" noenhanced
  set label 1003 ARG2 at screen 0.995, 0.015 right font ",13" noenhanced
  load "labels.gp"
  set lmargin at screen 0.09
  set rmargin at screen 0.91
  set bmargin at screen (ARG2 eq "" ? 0.105 : 0.125)
  set tmargin at screen (curves > 0 ? 0.84 - 0.035 * ((curves + 1) / 2) : 0.9)
  set border 3
  set tics nomirror out
  set grid xtics ytics mxtics mytics linewidth 0.7 linecolor rgb "#CCCCCC", linewidth 0.4 linecolor rgb "#E5E5E5"
  set logscale xy
  set format x "10^{%L}"
  set format y "%g"
  set xrange [least_stiffness:most_stiffness]
  set yrange [low:high]
  set xlabel "stiffness of each bearing (N/m)"
  set label 1004 ARG3 at screen 0.018, 0.5 center rotate by 90
  if (band_to > band_from) {
    set object 1 rectangle from graph 0, first band_from to graph 1, first band_to behind fillcolor rgb "#EEEEDD" fillstyle solid noborder
    set label 1005 "operating range" at graph 0.01, first band_to left offset 0, -0.7 font ",15" textcolor rgb "#666644"
  }
  set key at screen 0.09, screen 0.94 left top Left reverse noopaque samplen 2 maxcols 2 maxrows ((curves + 2) / 2) noenhanced
  plot "modes" using 1:2 with lines linewidth 2.5 linecolor rgb "#332288" title "critical speed", \
    for [k = 0:curves - 1] sprintf("curve_%d", k) using 1:2 with lines linewidth 2.5 linecolor rgb colour[k + 1] \
      title value(sprintf("curve_name_%d", k))
  unset output
}
