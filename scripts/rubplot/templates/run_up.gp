# Draws the run-up through rub that pictures/run_up.py lays out.
# Arguments: HEADING SPEEDS WALL ORBITS REACH ORDER BYLINE
# SPEEDS: least and largest, and their unit; WALL: clearance in mm, angle in degrees or nan; ORBITS: their speeds; REACH: half the
# width of an orbit's panel in mm; ORDER: the largest one that is drawn.

heading = ARG1
least = real(word(ARG2, 1))
largest = real(word(ARG2, 2))
unit = word(ARG2, 3)
clearance = real(word(ARG3, 1))
flat = word(ARG3, 2) ne "nan"
angle = flat ? real(word(ARG3, 2)) * pi / 180 : 0
orbits = ARG4
reach = real(ARG5)
order = int(ARG6)

# Colours: Paul Tol's "muted" scheme, made for colour-blind readers.
rotor = "#332288"
wall = "#CC6677"
steady = "#117733"
width = 1600.0
height = 1650.0
left = 0.09
right = 0.85
panels = words(orbits)
panel = (right - left) / (panels > 0 ? panels : 1)

stats "spectrogram" using 5 name "A" nooutput
top_amplitude = A_records > 0 ? A_max : 1

do for [format in formats] {
  eval canvas(format, width, height, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set label 1 heading at screen 0.47, 0.98 center font ":Bold,22" noenhanced
  set label 9 ARG7 at screen 0.995, 0.012 right font ",13" noenhanced

  # Strip of orbits, each at its place on the axis of speeds.
  set border 15 linewidth 0.7
  unset xtics
  unset ytics
  set parametric
  set trange [0:2 * pi]
  set samples 200
  set xrange [-reach:reach]
  set yrange [-reach:reach]
  do for [i = 1:panels] {
    place = largest > least ? (real(word(orbits, i)) - least) / (largest - least) : 0.5
    middle = left + place * (right - left)
    set lmargin at screen middle - 0.46 * panel
    set rmargin at screen middle + 0.46 * panel
    set tmargin at screen 0.93
    set bmargin at screen 0.93 - 0.92 * panel * width / height
    set label 2 word(orbits, i) . " " . unit at screen middle, 0.94 center font ",15"
    if (flat) {
      plot clearance * cos(angle) - (t - pi) * reach * sin(angle), clearance * sin(angle) + (t - pi) * reach * cos(angle) \
          with lines dashtype 2 linecolor rgb "black" notitle, \
        "orbits" index (i - 1) using 1:2 with lines linewidth 0.8 linecolor rgb rotor notitle
    } else {
      plot clearance * cos(t), clearance * sin(t) with lines dashtype 2 linecolor rgb "black" notitle, \
        "orbits" index (i - 1) using 1:2 with lines linewidth 0.8 linecolor rgb rotor notitle
    }
    unset label
  }
  unset parametric

  # Envelope.
  set border 31 linewidth 1
  set xtics nomirror out autofreq
  set ytics nomirror out autofreq
  set lmargin at screen left
  set rmargin at screen right
  set tmargin at screen 0.772
  set bmargin at screen 0.50
  set xrange [least:largest]
  speed_label = sprintf("shaft speed (%s)", unit)
  eval rpm_above(speed_label)
  set yrange [*:*]
  set offsets 0, 0, graph 0.05, graph 0.05
  set format x ""
  # Not as labels of the axes: beside a fixed margin these may come over the numbers.
  set label 4 "displacement (mm)" at screen 0.011, 0.65 center rotate by 90
  set key at screen 0.47, 0.844 center top horizontal Left reverse samplen 2 maxrows 2 font ',17'
    plot "envelope" using 1:2:3 with filledcurves linecolor rgb rotor fillstyle solid 0.35 noborder title "y", \
    "envelope" using 1:4 with lines linewidth 1.2 linecolor rgb rotor title "largest distance", \
    "steady" using 1:2 with points pointtype 7 pointsize 0.5 linecolor rgb steady title "at steady speed", \
    clearance with lines dashtype 2 linecolor rgb "black" title "clearance at rest"
  unset offsets
  unset key
  unset label

  eval no_rpm

  # Where it rubs.
  set tmargin at screen 0.475
  set bmargin at screen 0.425
  set yrange [-0.6:1.6]
  set ytics ("steady" 0, "ramp" 1) nomirror out
  plot "rub" using 1:3:1:2:($3 - 0.35):($3 + 0.35) with boxxyerror linecolor rgb wall fillstyle solid 0.8 noborder notitle, \
    NaN notitle
  set label 3 "rubs" at screen right + 0.01, 0.45 left

  # Spectrogram.
  set tmargin at screen 0.40
  set bmargin at screen 0.07
  set ytics autofreq nomirror out
  set ytics 1
  set yrange [-order - 0.2:order + 0.2]
  set format x "% h"
  set xlabel speed_label
  set label 4 "order (backward < 0 < forward)" at screen 0.018, 0.235 center rotate by 90
  set logscale cb
  set cbrange [top_amplitude / 300:top_amplitude]
  set palette defined (0 "#F4F4F4", 0.25 "#88CCEE", 0.5 "#4F9BD0", 0.75 "#332288", 1 "#000000")
  set cblabel "amplitude (mm)"
  set format cb "%g"
  set colorbox user origin right + 0.02, 0.09 size 0.02, 0.29
  plot "spectrogram" using 1:2:3:4:($2 - 0.02):($2 + 0.02):5 with boxxyerror \
      fillstyle solid 1 noborder linecolor palette notitle
  unset logscale cb
  unset label
  unset multiplot
  unset output
}
