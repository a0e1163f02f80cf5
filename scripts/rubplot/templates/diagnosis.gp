# Draws the diagnosis that pictures/diagnosis.py lays out.
# Arguments: HEADING UNIT PLANE WIDEST CANDIDATES
# Files: bars (place, percent, name), recorded and simulated (x, y in UNIT; of one probe turns and x), spectrum (order,
# recorded, simulated).

heading = ARG1
unit = ARG2
plane = int(ARG3)
widest = real(ARG4)
candidates = int(ARG5)
blue = "#332288"
green = "#117733"
# Here, while no axis has a range.
stats "spectrum" using 2 name "L" nooutput
largest_line = L_max
stats "spectrum" using (abs($1)) name "O" nooutput
farthest_line = O_max < 2 ? 2 : 1.05 * O_max

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
  set tmargin at screen 0.84
  set bmargin at screen 0.11
  if (plane) {
    set size ratio -1
    set xrange [-widest:widest]
    set yrange [-widest:widest]
    set xlabel sprintf("x (%s)", unit)
    set label 3 sprintf("y (%s)", unit) at screen 0.02, 0.47 center rotate by 90
  } else {
    set xlabel "turns of the shaft"
    set label 3 sprintf("x (%s)", unit) at screen 0.02, 0.47 center rotate by 90
  }
  set key at screen 0.285, 0.925 center top horizontal maxrows 1 Left reverse samplen 2 noenhanced
  plot "recorded" using 1:2 with lines linewidth 2 linecolor rgb blue title "recorded", \
    "simulated" using 1:2 with lines dashtype 2 linewidth 2 linecolor rgb green title "closest simulated motion"
  unset label 1
  unset label 3
  unset key
  set size noratio
  set autoscale xy

  set lmargin at screen 0.70
  set rmargin at screen 0.96
  set tmargin at screen 0.90
  set bmargin at screen 0.58
  set xrange [0:100]
  set yrange [-candidates + 0.5:0.5]
  set xlabel "probability (%)"
  set ytics noenhanced
  set style fill solid 0.85 noborder
  plot "bars" using 2:1:(0):2:($1 - 0.35):($1 + 0.35):ytic(3) with boxxyerror linecolor rgb blue
  unset ytics
  set ytics nomirror out
  set autoscale xy

  set lmargin at screen 0.61
  set tmargin at screen 0.46
  set bmargin at screen 0.11
  set logscale y
  set format y "10^{%L}"
  set yrange [largest_line * 5e-4:largest_line * 2]
  # A motion may be a single line.
  set xrange [-farthest_line:farthest_line]
  set xlabel "order (multiples of the speed)"
  set label 4 sprintf("amplitude (%s)", unit) at screen 0.515, 0.285 center rotate by 90
  plot "spectrum" using 1:2 with impulses linewidth 3 linecolor rgb blue, \
    "spectrum" using 1:3 with points pointtype 6 pointsize 0.9 linewidth 1.5 linecolor rgb green
  unset multiplot
}
