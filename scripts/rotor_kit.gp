# Draws the identification of a rotor from its free response and its run-up.
# gnuplot -c rotor_kit.gp DIRECTORY OUTPUT_BASENAME SENSOR NATURAL_FREQUENCY_HZ DAMPING_RATIO CRITICAL_SPEED_HZ
directory = ARG1
output = ARG2
sensor = int(ARG3)
natural_hz = real(ARG4)
damping = real(ARG5)
critical_hz = real(ARG6)

set datafile separator ","
line = "#332288"
second = "#CC6677"
mark = "#999933"
free = directory . "/free_response/sensors.csv"
bode = directory . "/run_up/bode.csv"

do for [kind in "png svg"] {
  if (kind eq "png") { set terminal pngcairo size 1600,900 font "sans,20" } else { set terminal svg size 1600,900 font "sans,20" }
  set output output . "." . kind
  set multiplot title sprintf("Rotor kit: natural frequency %.3f Hz, damping ratio %.4f; critical speed %.2f Hz", natural_hz, damping, critical_hz)
  set grid lc rgb "#DDDDDD"
  set lmargin 11
  set tics nomirror
  set border 3

  set origin 0, 0
  set size 0.5, 0.93
  set title sprintf("Free response to an impulse, sensor %d", sensor)
  set xlabel "time (s)"
  set ylabel "displacement (mm)"
  set key top right
  stats free using 0:(column(4 + sensor)) every ::1 nooutput name "F"
  # The fit starts after the first quarter; its envelope through the largest sample there.
  quarter = F_records / 4
  stats free using 1 every ::(int(quarter) + 1)::(int(quarter) + 1) nooutput name "T"
  stats free using (abs(column(4 + sensor))) every ::(int(quarter) + 1) nooutput name "A"
  rate = damping * 2 * pi * natural_hz
  set xrange [0:*]
  plot free using 1:(1e3 * column(4 + sensor)) every ::1 with lines lc rgb line title "1 ms samples", \
    free using 1:($1 >= T_min ? 1e3 * A_max * exp(-rate * ($1 - T_min)) : NaN) every ::1 with lines lw 3 lc rgb second title "fitted decay", \
    free using 1:($1 >= T_min ? -1e3 * A_max * exp(-rate * ($1 - T_min)) : NaN) every ::1 with lines lw 3 lc rgb second notitle

  set xrange [*:*]
  set origin 0.5, 0.46
  set size 0.5, 0.47
  set title "Run-up: component that turns with the shaft"
  unset xlabel
  set ylabel "amplitude (µm)"
  set arrow 1 from critical_hz, graph 0 to critical_hz, graph 1 nohead dt 2 lw 2 lc rgb mark
  plot bode using 1:(1e6 * $2) every ::1 with linespoints pt 7 ps 0.5 lc rgb line title "sensor 0", \
    bode using 1:(1e6 * $4) every ::1 with lines lw 2 dt 3 lc rgb second title "sensor 1"
  set origin 0.5, 0
  unset title
  set xlabel "shaft speed (Hz)"
  set ylabel "phase (deg)"
  set yrange [-200:20]
  set ytics 45
  plot bode using 1:3 every ::1 with linespoints pt 7 ps 0.5 lc rgb line notitle, \
    bode using 1:5 every ::1 with lines lw 2 dt 3 lc rgb second notitle
  unset arrow 1
  set autoscale
  set ytics autofreq
  unset multiplot
  unset output
}
