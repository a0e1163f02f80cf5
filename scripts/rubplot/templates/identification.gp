# Draws the identification of a rotor from its free response and its run-up.
# Arguments: HEADING SENSOR NATURAL_FREQUENCY_HZ DAMPING_RATIO CRITICAL_SPEED_HZ BYLINE
# Files: free (time and the reading of the sensor), bode (speed, amplitude and phase of two sensors).

heading = ARG1
sensor = int(ARG2)
natural_hz = real(ARG3)
damping = real(ARG4)
resonance_hz = real(ARG5)

line = "#332288"
second = "#CC6677"
mark = "#999933"
free = "free"
bode = "bode"

do for [format in formats] {
  eval canvas(format, 1600, 900, 'sans,20', 1)
  set multiplot title heading . sprintf(": natural frequency %.3f Hz, damping ratio %.4f; resonance %.2f Hz", natural_hz, damping, resonance_hz) noenhanced
  set label 2 ARG6 at screen 0.995, screen 0.012 right font ",13" noenhanced
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
  stats free using 0:($2) nooutput name "F"
  # The fit starts after the first quarter; its envelope through the largest sample there.
  quarter = F_records / 4
  stats free using 1 every ::(int(quarter) + 1)::(int(quarter) + 1) nooutput name "T"
  stats free using (abs($2)) every ::(int(quarter) + 1) nooutput name "A"
  rate = damping * 2 * pi * natural_hz
  set xrange [0:*]
  plot free using 1:(1e3 * $2) with lines lc rgb line title "1 ms samples", \
    free using 1:($1 >= T_min ? 1e3 * A_max * exp(-rate * ($1 - T_min)) : NaN) with lines lw 3 lc rgb second title "fitted decay", \
    free using 1:($1 >= T_min ? -1e3 * A_max * exp(-rate * ($1 - T_min)) : NaN) with lines lw 3 lc rgb second notitle
  unset label 2

  set xrange [*:*]
  set origin 0.5, 0.46
  set size 0.5, 0.47
  set title "Run-up: component that turns with the shaft"
  unset xlabel
  set ylabel "amplitude (µm)"
  speed_label = "shaft speed (Hz)"
  eval rpm_above(speed_label)
  set arrow 1 from resonance_hz, graph 0 to resonance_hz, graph 1 nohead dt 2 lw 2 lc rgb mark
  plot bode using 1:(1e6 * $2) with linespoints pt 7 ps 0.5 lc rgb line title "sensor 0", \
    bode using 1:(1e6 * $4) with lines lw 2 dt 3 lc rgb second title "sensor 1"
  eval no_rpm
  set origin 0.5, 0
  unset title
  set xlabel speed_label
  set ylabel "phase (deg)"
  set yrange [-200:20]
  set ytics 45
  plot bode using 1:3 with linespoints pt 7 ps 0.5 lc rgb line notitle, \
    bode using 1:5 with lines lw 2 dt 3 lc rgb second notitle
  unset arrow 1
  set autoscale
  set ytics autofreq
  unset multiplot
  unset output
}
