# Draws where on the ring a second load couples with the first.
# Argument: HEADING. Files: couplings_2 and couplings_3, by the number of nodal diameters, the angles (deg) of the second load
# at which the two couple; first_load, the line from the middle to the first one.

do for [format in formats] {
  eval canvas(format, 1700, 900, 'DejaVu Sans,18', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot layout 1, 2 title ARG1 font ":Bold,22" margins 0.08, 0.97, 0.13, 0.84 spacing 0.09
  set polar
  unset raxis
  set size square
  unset border
  unset tics
  unset key
  do for [n = 2:3] {
    set angles degrees
    set rrange [0:1.35]
    set xrange [-1.35:1.35]
    set yrange [-1.35:1.35]
    set title (n == 2 ? "a) two" : "b) three") . " nodal diameters" font ":Bold" offset 0, 1
    unset object
    unset label
    set object circle at 0, 0 size 1 fillstyle empty border linecolor rgb "black" linewidth 2
    set label 1 "first load" at 1.14 * cos(60), 1.14 * sin(60) left
    do for [a = 0:330:30] { if (a != 60) { set label sprintf("%d°", a) at 1.22 * cos(a), 1.22 * sin(a) center font ",14" } }
    plot "couplings_" . n using 1:(0.92) with points pointtype 7 pointsize 1.0 linecolor rgb "#AA4499", \
      "first_load" using 1:2 with lines linecolor rgb "#332288" linewidth 3
  }
  unset multiplot
  unset output
}
