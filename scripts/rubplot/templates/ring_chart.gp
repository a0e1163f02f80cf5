# Draws the onsets that pictures/ring_chart.py lays out, over the parameter of a chart.
# Arguments: HEADING X_LABEL FROM TO TOP BYLINE
# Files: one of each kind of onset (parameter, rpm). FROM, TO, TOP: the ends of the axes, * where gnuplot chooses.

set encoding utf8
set minussign
set title ARG1 font ":Bold" noenhanced
set label 1 ARG6 at screen 0.995, screen 0.012 right font ",12" noenhanced
set xlabel ARG2 noenhanced
set ylabel "speed (rpm)"
eval sprintf("set xrange [%s:%s]", ARG3, ARG4)
eval sprintf("set yrange [0:%s]", ARG5)
set xtics autofreq out nomirror
set ytics out nomirror
set key outside right top Left reverse samplen 1
do for [format in formats] {
  eval canvas(format, 1500, 1000, 'DejaVu Sans,19', 1.5)
  plot "coupling_begin" using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb "#44AA99" title "coupling begins (µ = 0)", \
    "coupling_end" using 1:2 with points pointtype 6 pointsize 0.8 linecolor rgb "#44AA99" title "coupling ends (µ = 0)", \
    "divergence_begin" using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb "#AA4499" title "divergence begins", \
    "divergence_end" using 1:2 with points pointtype 6 pointsize 0.8 linecolor rgb "#AA4499" title "divergence ends", \
    "flutter_begin" using 1:2 with points pointtype 7 pointsize 0.5 linecolor rgb "#CC6677" title "flutter begins", \
    "flutter_end" using 1:2 with points pointtype 6 pointsize 0.6 linecolor rgb "#CC6677" title "flutter ends"
  unset output
}
