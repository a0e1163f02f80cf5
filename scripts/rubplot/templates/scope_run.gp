# Draws the run-up that pictures/scope.py lays out.
# Arguments: HEADING CURVES UNIT RESONANCES SPEED_LABEL
# Files: curve_N for each of the CURVES (speed, amplitude in UNIT, phase in degrees, x and y of the polar plot), names.gp
# (also whether there are phases), spectra (order, half the width of a line, speed, its least and largest, amplitude).

heading = ARG1
curves = int(ARG2)
unit = ARG3
resonances = ARG4
file(i) = "curve_" . i
load "names.gp"
# Paul Tol's "muted" scheme, curve by curve.
array colours[8] = ["#332288", "#CC6677", "#117733", "#DDCC77", "#882255", "#44AA99", "#AA4499", "#999933"]
mark = "#999999"
# Here, while no axis has a range.
stats "spectra" using 6 name "S" nooutput
stats file(0) using 1 name "V" nooutput
widest = 0
if (phased) {
  stats file(0) using 4 name "X" nooutput
  stats file(0) using 5 name "Y" nooutput
  widest = 1.05 * (abs(X_min) > X_max ? abs(X_min) : X_max)
  widest = 1.05 * (abs(Y_min) > Y_max ? abs(Y_min) : Y_max) > widest ? 1.05 * (abs(Y_min) > Y_max ? abs(Y_min) : Y_max) : widest
}
if (curves > 1) {
  stats file(1) using 2 name "R" nooutput
  widest = 1.05 * R_max > widest ? 1.05 * R_max : widest
}
if (widest == 0) { widest = 1 }

do for [format in formats] {
  eval canvas(format, 1600, 1100, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set label 1 heading at screen 0.5, 0.965 center font ":Bold,22" noenhanced
  set tics nomirror out
  set grid linecolor rgb "#E4E4E4"
  do for [k = 1:words(resonances)] {
    set arrow k from first real(word(resonances, k)), graph 0 to first real(word(resonances, k)), graph 1 nohead \
      dashtype 2 linewidth 1.2 linecolor rgb mark
  }

  set lmargin at screen 0.105
  set rmargin at screen 0.49
  set tmargin at screen 0.82
  eval rpm_above(ARG5)
  set bmargin at screen 0.52
  set xrange [V_min:V_max]
  set yrange [0:*]
  set format x ""
  set label 2 sprintf("amplitude (%s)", unit) at screen 0.015, 0.67 center rotate by 90
  # Above the numbers of the upper axis.
  set key at screen 0.105, screen 0.942 left top horizontal maxrows 2 Left reverse samplen 1.5 font ",16" noenhanced
  plot for [i = 0:curves - 1] file(i) using 1:2 with lines linewidth 2 linecolor rgb colours[i + 1] \
      title value(sprintf("name_%d", i))
  unset label 1
  unset key

  eval no_rpm
  set tmargin at screen 0.48
  set bmargin at screen 0.11
  set format x "% h"
  if (phased) { set yrange [*:*] }
  # A run-up without a mark has no phases.
  if (!phased) { set yrange [-180:180] }
  set ytics 90
  set xlabel ARG5
  set label 2 "phase of 1X (deg)" at screen 0.015, 0.29 center rotate by 90
  # Its name stands beside a line of resonance, where there is more room.
  if (words(resonances)) {
    place = real(word(resonances, 1))
    name = "resonance " . word(resonances, 1) . (strstrt(ARG5, "rpm") ? " rpm" : " Hz")
    if (place > (V_min + V_max) / 2) { set label 3 name at first place, graph 0.06 right offset character -0.6, 0 font ",16" }
    if (place <= (V_min + V_max) / 2) {
      set label 3 name at first real(word(resonances, words(resonances))), graph 0.06 left offset character 0.6, 0 font ",16"
    }
  }
  plot for [i = 0:(curves > 1 ? 1 : 0)] file(i) using 1:3 with lines linewidth 2 linecolor rgb colours[i + 1]
  do for [k = 1:words(resonances)] { unset arrow k }
  unset label 3

  set lmargin at screen 0.60
  set rmargin at screen 0.97
  set tmargin at screen 0.90
  set bmargin at screen 0.52
  set size ratio -1
  set xrange [-widest:widest]
  set yrange [-widest:widest]
  # Numbers at the axes of a small square: two to a side, of one digit.
  power = 10.0 ** floor(log10(0.5 * widest))
  step = power * floor(0.5 * widest / power + 0.5)
  set xtics step
  set ytics step
  set xlabel sprintf("1X in polar form (%s): phase 0° to the right", unit)
  unset label 2
  plot for [i = 0:(curves > 1 ? 1 : 0)] file(i) using 4:5 with lines linewidth 2 linecolor rgb colours[i + 1]
  set size noratio

  set lmargin at screen 0.60
  set rmargin at screen 0.88
  set tmargin at screen 0.41
  set bmargin at screen 0.11
  unset grid
  set xrange [-8:8]
  set yrange [V_min:V_max]
  set xtics 2
  set xlabel "order"
  set ytics autofreq
  set label 2 ARG5 at screen 0.53, 0.26 center rotate by 90
  set logscale cb
  set cbrange [1e-3 * S_max:S_max]
  set format cb "10^{%L}"
  set cblabel sprintf("amplitude (%s)", unit) offset character 1.5, 0
  set palette defined (0 "#FFFFFF", 1 "#AACCE8", 2 "#4477AA", 3 "#332288", 4 "#220022")
  plot "spectra" using 1:3:($1 - $2):($1 + $2):4:5:6 with boxxyerror fillstyle solid 1 noborder linecolor palette
  unset multiplot
  unset output
}
