# Draws the rotor that pictures/rotor.py lays out.
# Arguments: HEADING BYLINE
# Files: parts and labels.gp.

do for [format in formats] {
  eval canvas(format, 2000, 800, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set label 1000 ARG1 at screen 0.5, 0.965 center font ":Bold,24" noenhanced
  set label 1003 ARG2 at screen 0.995, 0.02 right font ",13" noenhanced
  set style textbox opaque noborder fillcolor rgb "white" margins 0.3, 0.1
  load "labels.gp"
  set lmargin at screen 0.08
  set rmargin at screen 0.985
  set bmargin at screen (ARG2 eq "" ? 0.135 : 0.16)
  set tmargin at screen 0.86
  set border 3
  set tics nomirror out
  set xrange [-0.04 * length:1.04 * length]
  set yrange [bottom:top]
  set xlabel "place along the shaft (mm)"
  if (any_layers || any_disc) {
    set ytics
    set label 1004 "radius (mm)" at screen 0.014, 0.5 center rotate by 90
  } else {
    unset ytics
    set arrow from 0, 0 to length, 0 nohead linewidth 4 linecolor rgb "#88CCEE"
  }
  set arrow from graph 0, first 0 to graph 1, first 0 nohead dashtype 4 linewidth 0.7 linecolor rgb "#555555" front
  set key at screen 0.07, screen 0.935 left top horizontal Left reverse noopaque samplen 1.5 maxrows 1
  below = 0.05 * radius
  plot "parts" using 1:($3 == 0 ? -$2 - 2.2 * below : NaN) with points pointtype 9 pointsize 2.6 linecolor rgb "#117733" \
      title (any_bearing ? "bearing" : ""), \
    "parts" using 1:($3 == 1 ? $2 + below : NaN) with points pointtype 5 pointsize 1.2 linecolor rgb "#332288" \
      title (any_seal ? "seal" : ""), \
    "parts" using 1:($3 == 1 ? -$2 - below : NaN) with points pointtype 5 pointsize 1.2 linecolor rgb "#332288" notitle, \
    "parts" using 1:($3 == 2 ? $2 + 1.5 * below : NaN) with points pointtype 2 pointsize 1.9 linewidth 2 linecolor rgb "black" \
      title (any_stop ? "stop" : ""), \
    "parts" using 1:($3 == 2 ? -$2 - 1.5 * below : NaN) with points pointtype 2 pointsize 1.9 linewidth 2 linecolor rgb "black" notitle, \
    "parts" using 1:($3 == 3 ? $2 + 2.2 * below : NaN) with points pointtype 11 pointsize 2 linecolor rgb "#AA4499" \
      title (any_probe ? "probe" : ""), \
    "parts" using 1:($3 == 4 ? 0 : NaN) with points pointtype 7 pointsize 1.6 linecolor rgb "#882255" \
      title (any_point_mass ? "point mass" : ""), \
    "parts" using 1:($3 == 5 ? 0 : NaN) with points pointtype 4 pointsize 2.2 linewidth 2 linecolor rgb "#882255" \
      title (any_coupling ? "coupling" : ""), \
    "parts" using 1:($3 == 6 ? 0 : NaN) with points pointtype 13 pointsize 1.8 linecolor rgb "#999933" title (any_load ? "load" : "")
  unset output
}
