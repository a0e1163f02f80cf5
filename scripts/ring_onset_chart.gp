# Draws onsets over the inclination: gnuplot -c ring_onset_chart.gp DIRECTORY OUTPUT_BASENAME FIGURE
# DIRECTORY holds alpha.KIND for each kind of onset (inclination in deg, speed in rpm). Figure 20 shows everything, figure
# 21 the range where the forward mode and the beam couple and diverge.

directory = ARG1
output = ARG2
figure = int(ARG3)
set terminal pngcairo size 1500, 1000 font "DejaVu Sans,19" linewidth 1.5
set output output . ".png"
set encoding utf8
set minussign
set title (figure == 20 ? "Onsets over the inclination of the beam, µ = 0.1" : "Coupling with the forward mode and divergence of the beam, µ = 0.1") font ":Bold"
set xlabel "inclination (°)"
set ylabel "speed (rpm)"
set xrange [0:89]
set yrange [0:figure == 20 ? 6000 : 3000]
set xtics 10 out nomirror
set ytics out nomirror
set key outside right top Left reverse samplen 1
onsets(kind) = directory . "/alpha." . kind
plot onsets("coupling_begin") using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb "#44AA99" title "coupling begins (µ = 0)", \
  onsets("coupling_end") using 1:2 with points pointtype 6 pointsize 0.8 linecolor rgb "#44AA99" title "coupling ends (µ = 0)", \
  onsets("divergence_begin") using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb "#AA4499" title "divergence begins", \
  onsets("divergence_end") using 1:2 with points pointtype 6 pointsize 0.8 linecolor rgb "#AA4499" title "divergence ends", \
  onsets("flutter_begin") using 1:2 with points pointtype 7 pointsize 0.5 linecolor rgb "#CC6677" title "flutter begins", \
  onsets("flutter_end") using 1:2 with points pointtype 6 pointsize 0.6 linecolor rgb "#CC6677" title "flutter ends"
