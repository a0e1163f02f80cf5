# Draws the recording that pictures/scope.py lays out.
# Arguments: HEADING LABEL UNIT PLANE WIDEST COMPARED SPEED_LABEL
# Files: orbit and section (x, y in UNIT; of one probe turns and x), spectrum (order, amplitude, noise), speed (s, speed);
# where COMPARED is 1 simulated (as orbit) and simulated_spectrum (order, amplitude).

heading = ARG1
unit = ARG3
plane = int(ARG4)
widest = real(ARG5)
compared = int(ARG6)
blue = "#332288"
red = "#CC6677"

# Nothing, or the element of a plot; before the loop, which is read as a whole.
style = " linecolor rgb \"#117733\" title \"simulated\""
simulated_orbit = compared ? ", \"simulated\" using 1:2 with lines dashtype 2 linewidth 2" . style : ""
simulated_lines = compared ? \
  ", \"simulated_spectrum\" using 1:2 with points pointtype 6 pointsize 0.9 linewidth 1.5" . style : ""
# Here, while no axis has a range.
stats "spectrum" using 2 name "L" nooutput
largest_line = L_max
stats "spectrum" using 3 name "N" nooutput
smallest_noise = N_min

do for [format in formats] {
  eval canvas(format, 1600, 1000, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set label 1 heading at screen 0.5, 0.965 center font ":Bold,22" noenhanced
  set tics nomirror out
  set grid linecolor rgb "#E4E4E4"

  set lmargin at screen 0.09
  set rmargin at screen 0.48
  set tmargin at screen 0.82
  set bmargin at screen 0.11
  if (plane) {
    set size ratio -1
    set xrange [-widest:widest]
    set yrange [-widest:widest]
    set xlabel sprintf("x (%s)", unit)
    set label 3 sprintf("y (%s)", unit) at screen 0.02, 0.42 center rotate by 90
  } else {
    set xlabel "turns of the shaft"
    set label 3 sprintf("x (%s)", unit) at screen 0.02, 0.42 center rotate by 90
  }
  set key at screen 0.285, 0.93 center top horizontal maxrows 2 Left reverse samplen 2 noenhanced
  plot "orbit" using 1:2 with lines linewidth 2 linecolor rgb blue title "mean motion, " . ARG2, \
    "section" using 1:2 with points pointtype 7 pointsize 1.1 linecolor rgb red title "at the mark" \
    @simulated_orbit
  unset label 1
  unset label 3
  set size noratio
  set autoscale xy

  set lmargin at screen 0.61
  set rmargin at screen 0.97
  set tmargin at screen 0.86
  set bmargin at screen 0.56
  set logscale y
  set format y "10^{%L}"
  set xrange [-8:8]
  set xtics 2
  set xlabel "order"
  # Not as labels of the axes, which may come over the numbers at them.
  set label 2 sprintf("amplitude (%s)", unit) at screen 0.503, 0.71 center rotate by 90
  set key at screen 0.785, 0.93 center top horizontal maxrows 1 Left reverse samplen 2
  set yrange [1e-3 * largest_line:2 * largest_line]
  if (smallest_noise > 0) {
    set yrange [0.3 * smallest_noise:2 * largest_line]
  }
  plot "spectrum" using 1:2 with impulses linewidth 3 linecolor rgb blue notitle, \
    "spectrum" using 1:3 with lines dashtype 2 linewidth 1.5 linecolor rgb red title "noise of a line" \
    @simulated_lines
  unset logscale y
  set format y "% h"
  set autoscale xy
  set xtics autofreq
  unset key

  set tmargin at screen 0.41
  set bmargin at screen 0.11
  set xlabel "time (s)"
  set label 2 ARG7 at screen 0.503, 0.26 center rotate by 90
  stats "speed" using 2 name "S" nooutput
  pad = S_max - S_min > 1e-6 * S_max ? 0.1 * (S_max - S_min) : 0.01 * S_max
  set yrange [S_min - pad:S_max + pad]
  plot "speed" using 1:2 with lines linewidth 2 linecolor rgb blue
  unset multiplot
  unset output
}
