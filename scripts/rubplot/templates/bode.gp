# Draws the Bode plot that pictures/bode.py lays out.
# Arguments: HEADING SENSORS UNIT CRITICAL BYLINE SPEED_LABEL
# Files: sensor_N for each of the SENSORS (speed, amplitude in UNIT, phase in degrees) and names.gp; CRITICAL: the
# resonances fitted to them.

heading = ARG1
sensors = int(ARG2)
unit = ARG3
resonance = ARG4
file(i) = "sensor_" . i
load "names.gp"

# Paul Tol's "muted" scheme, sensor by sensor.
array colours[8] = ["#332288", "#CC6677", "#117733", "#DDCC77", "#882255", "#44AA99", "#AA4499", "#999933"]
mark = "#999999"
listed = word(resonance, 1)
do for [k = 2:words(resonance)] { listed = listed . ", " . word(resonance, k) }
dash(i) = i % 2 ? 2 : 1
# Here, while no axis has a range: of what lies outside the range of an axis, stats sees nothing.
stats file(0) using 1 name "S" nooutput
low = NaN
high = NaN
do for [i = 0:sensors - 1] {
  stats file(i) using 3 name "P" nooutput
  low = P_min < low || i == 0 ? P_min : low
  high = P_max > high || i == 0 ? P_max : high
}
# Whole eighths of a turn, and the zero with them.
bottom = 45 * floor((low < 0 ? low : 0) / 45.0 - 0.1)
top = 45 * ceil((high > 0 ? high : 0) / 45.0 + 0.1)
phase_step = top - bottom > 720 ? 180 : top - bottom > 360 ? 90 : 45

do for [format in formats] {
  eval canvas(format, 1600, 1100, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set label 1 heading at screen 0.5, 0.965 center font ":Bold,22" noenhanced
  set label 2 ARG5 at screen 0.995, 0.012 right font ",13" noenhanced
  set lmargin at screen 0.11
  set rmargin at screen 0.97
  set tics nomirror out
  set grid linecolor rgb "#E4E4E4"
  do for [k = 1:words(resonance)] {
    set arrow from first real(word(resonance, k)), graph 0 to first real(word(resonance, k)), graph 1 nohead dashtype 2 \
      linewidth 1.2 linecolor rgb mark
  }
  set key top right Left reverse samplen 2.5 spacing 1.2 opaque noenhanced

  set tmargin at screen 0.89
  eval rpm_above(ARG6)
  set bmargin at screen 0.47
  set xrange [S_min:S_max]
  set yrange [0:*]
  set format x ""
  # Not as labels of the axes, which may come over the numbers at them.
  set label 3 sprintf("1X amplitude (%s)", unit) at screen 0.025, 0.69 center rotate by 90
  plot for [i = 0:sensors - 1] file(i) using 1:2 with lines linewidth 2 dashtype dash(i) \
      linecolor rgb colours[i + 1] title value(sprintf("name_%d", i)), \
    NaN with lines dashtype 2 linewidth 1.2 linecolor rgb mark \
      title (words(resonance) ? sprintf("resonance %s %s", listed, strstrt(ARG6, "rpm") ? "rpm" : "Hz") : "")
  unset label 1
  unset label 2
  unset key

  eval no_rpm
  set tmargin at screen 0.44
  set bmargin at screen 0.10
  set yrange [bottom:top]
  set ytics phase_step
  set format x "% h"
  set xlabel ARG6
  set label 3 "phase (°)" at screen 0.025, 0.27 center rotate by 90
  plot for [i = 0:sensors - 1] file(i) using 1:3 with lines linewidth 2 dashtype dash(i) \
    linecolor rgb colours[i + 1] notitle
  unset multiplot
  unset output
}
