# Draws the design check that pictures/design.py lays out.
# Arguments: HEADING PROBES STOPS BYLINE SPEED_LABEL
# Files: probe_N (speed, major axis in µm), limit (the same), stop_N (speed, share of the limit in %), kicks (speed, N),
# quiet and locks (speed, 0) and labels.gp.

heading = ARG1
probes = int(ARG2)
stops = int(ARG3)
probe(i) = "probe_" . i
stop(i) = "stop_" . i

# Paul Tol's "muted" scheme, place by place.
array colours[8] = ["#332288", "#CC6677", "#117733", "#DDCC77", "#882255", "#44AA99", "#AA4499", "#999933"]
mark = "#882255"
border = "#AA3311"
dash(i) = i % 2 ? 2 : 1

# Here, while no axis has a range: of what lies outside the range of an axis, stats sees nothing.
stats probe(0) using 1 name "S" nooutput

do for [format in formats] {
  eval canvas(format, 2000, 1200, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  load "labels.gp"
  set label 1000 heading at screen 0.5, 0.972 center font ":Bold,24" noenhanced
  set label 1003 ARG4 at screen 0.995, 0.013 right font ",13" noenhanced
  set border 31 linewidth 1
  set tics nomirror out
  set grid linecolor rgb "#E4E4E4"
  set xrange [S_min:S_max]
  eval rpm_above(ARG5)
  # Above the panels and the numbers there, so that nothing is behind it.
  above = strlen(rpm_above(ARG5)) ? 1.17 : 1.02
  set key at graph 0, graph above bottom left horizontal Left reverse samplen 2.2 spacing 1.1 noopaque noenhanced font ",17"

  set lmargin at screen 0.07
  set rmargin at screen 0.50
  set tmargin at screen 0.87
  set bmargin at screen 0.565
  set yrange [0:*]
  # The panel below has the same axis and its label, and its legend takes the place of one here.
  # Not as labels of the axes: beside a fixed margin these may come over the numbers.
  set label 1004 "probes (µm peak to peak)" at screen 0.015, 0.72 center rotate by 90
  plot for [i = 0:probes - 1] probe(i) using 1:2 with lines linewidth 2 dashtype dash(i) linecolor rgb colours[i + 1] \
      title value(sprintf("probe_name_%d", i)), \
    "limit" using 1:2 with lines linewidth 3 linecolor rgb border title sprintf("limit %.3g µm", limit)
  unset label

  eval no_rpm
  set key at graph 0, graph 1.02
  set xlabel ARG5
  set tmargin at screen 0.415
  set bmargin at screen 0.115
  set logscale y
  # Less than a ten-thousandth of the limit says nothing, and its numbers are long.
  set yrange [0.01<*:top_share]
  set label 1004 "axis / allowed at stops (%)" at screen 0.015, 0.265 center rotate by 90
  plot for [i = 0:stops - 1] stop(i) using 1:2 with lines linewidth 2 dashtype dash(i) linecolor rgb colours[i + 1] \
      title value(sprintf("stop_name_%d", i)), \
    100 with lines linewidth 3 linecolor rgb border title "limit"
  unset label
  unset logscale y

  eval rpm_above(ARG5)
  set key at graph 0, graph above
  set lmargin at screen 0.575
  set rmargin at screen 0.96
  set tmargin at screen 0.87
  set bmargin at screen 0.565
  set yrange [0:*]
  set label 1004 "kick that starts a rub (N)" at screen 0.52, 0.72 center rotate by 90
  if (any_kicks) {
    plot "kicks" using 1:2 with linespoints linewidth 2 pointtype 7 pointsize 1.2 linecolor rgb colours[1] \
        title "smallest kick", \
      "quiet" using 1:2 with points pointtype 2 pointsize 1.6 linewidth 2 \
        linecolor rgb colours[3] title (any_quiet ? "none of the kicks" : ""), \
      "locks" using 1:2 with points pointtype 12 pointsize 2 linewidth 2 \
        linecolor rgb mark title (any_locks ? "lock speed" : "")
  } else {
    set yrange [0:1]
    unset ytics
    if (!any_quiet) { set label 1005 "no kicks were tried" at graph 0.5, graph 0.5 center textcolor rgb "#777777" }
    plot "quiet" using 1:2 with points pointtype 2 pointsize 1.6 linewidth 2 \
        linecolor rgb colours[3] title (any_quiet ? "none of the kicks" : ""), \
      "locks" using 1:2 with points pointtype 12 pointsize 2 linewidth 2 \
        linecolor rgb mark title (any_locks ? "lock speed" : "")
    set ytics
  }
  unset multiplot
  unset output
}
