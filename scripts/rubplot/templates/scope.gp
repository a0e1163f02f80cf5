# Draws the recording that pictures/scope.py lays out.
# Arguments: HEADING LABEL UNIT PLANE WIDEST
# Files: orbit and section (x, y in UNIT; of one probe turns and x), spectrum (order, amplitude, noise), speed (s, Hz).

heading = ARG1
unit = ARG3
plane = int(ARG4)
widest = real(ARG5)
blue = "#332288"
red = "#CC6677"

do for [format in formats] {
  eval canvas(format, 1600, 1000, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set label 1 heading at screen 0.5, 0.965 center font ":Bold,22" noenhanced
  set tics nomirror out
  set grid linecolor rgb "#E4E4E4"

  set lmargin at screen 0.08
  set rmargin at screen 0.47
  set tmargin at screen 0.86
  set bmargin at screen 0.11
  if (plane) {
    set size ratio -1
    set xrange [-widest:widest]
    set yrange [-widest:widest]
    set xlabel sprintf("x (%s)", unit)
    set ylabel sprintf("y (%s)", unit)
  } else {
    set xlabel "turns of the shaft"
    set ylabel sprintf("x (%s)", unit)
  }
  set key at screen 0.275, 0.92 center top horizontal Left reverse samplen 2 noenhanced
  plot "orbit" using 1:2 with lines linewidth 2 linecolor rgb blue title "mean motion, " . ARG2, \
    "section" using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb red title "at the mark"
  unset label 1
  set size noratio
  set autoscale xy

  set lmargin at screen 0.58
  set rmargin at screen 0.97
  set tmargin at screen 0.86
  set bmargin at screen 0.56
  set logscale y
  set format y "10^{%L}"
  set xrange [-8:8]
  set xtics 2
  set xlabel "order"
  unset ylabel
  # Not as labels of the axes, which may come over the numbers at them.
  set label 2 sprintf("amplitude (%s)", unit) at screen 0.51, 0.71 center rotate by 90
  set key at screen 0.775, 0.92 center top horizontal Left reverse samplen 2
  plot "spectrum" using 1:2 with impulses linewidth 3 linecolor rgb blue notitle, \
    "spectrum" using 1:3 with lines dashtype 2 linewidth 1.5 linecolor rgb red title "noise of a line"
  unset logscale y
  set format y "% h"
  set autoscale xy
  set xtics autofreq
  unset key

  set tmargin at screen 0.41
  set bmargin at screen 0.11
  set xlabel "time (s)"
  set label 2 "shaft speed (Hz)" at screen 0.51, 0.26 center rotate by 90
  stats "speed" using 2 name "S" nooutput
  pad = S_max - S_min > 1e-6 * S_max ? 0.1 * (S_max - S_min) : 0.01 * S_max
  set yrange [S_min - pad:S_max + pad]
  plot "speed" using 1:2 with lines linewidth 2 linecolor rgb blue
  unset multiplot
  unset output
}
