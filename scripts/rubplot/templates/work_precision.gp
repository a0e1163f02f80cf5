# Draws error against time, one panel per cell, left located and right smoothed.
# Arguments: HEADING CELLS BYLINE
# File: data, blocks named CELL_CONTACT_STEPPER_METHOD, each line: time error. CELLS: number of cells.

heading = ARG1
cells = int(ARG2)
array stepper[6] = ["exact", "dopri5", "cash_karp54", "rkf78", "bulirsch_stoer", "rosenbrock4"]
# Paul Tol's "muted" scheme, made for colour-blind readers.
array colour[6] = ["#000000", "#332288", "#44AA99", "#CC6677", "#DDCC77", "#AA4499"]
array symbol[6] = [3, 7, 5, 9, 13, 11]

array contact[2] = ["located", "smoothed"]
array contact_title[2] = ["stops at every mode switch (located)", "blended contact law (smoothed)"]

load "settings.gp"  # cell_title[], low_time, high_time, low_error, high_error, has(name)

name(cell, c, s, method) = sprintf("%d_%s_%s_%s", cell, contact[c], stepper[s], method)
label(s, method) = s == 1 ? "exact, without a stepper" : \
  method eq "exact" ? "exact in flight, " . stepper[s] : stepper[s]
do for [format in formats] {
  eval canvas(format, 1800, 120 + 760 * cells, 'DejaVu Sans,18', 1.8)
  set multiplot layout cells, 2 title heading font ",24" noenhanced
  set label 1 ARG3 at screen 0.995, screen 0.006 right font ",12" noenhanced
  set logscale xy
  set format x "10^{%L}"
  set format y "10^{%L}"
  set xlabel "processor time per revolution (µs)"
  set ylabel "error after 6 revolutions (clearance)"
  set xrange [low_time:high_time]
  set yrange [low_error:high_error]
  set grid xtics ytics linecolor rgb "#DDDDDD"
  set key outside below center horizontal maxcols 3 height 1 font ",16"
  do for [cell = 1:cells] {
    do for [c = 1:2] {
      curves = ""
      do for [s = 1:6] {
        do for [method in "exact adaptive"] {
          if (has(name(cell, c, s, method))) {
            curves = curves . sprintf("'data' index \"%s\" using 1:2 with linespoints linecolor rgb \"%s\" " . \
              "pointtype %d pointsize %g dashtype %d title \"%s\" noenhanced, ", name(cell, c, s, method), colour[s], \
              symbol[s], s == 1 ? 4 : 1.8, method eq "exact" ? 2 : 1, label(s, method))
          }
        }
      }
      set title cell_title[cell] . "\n" . contact_title[c]
      if (strlen(curves) > 0) { eval "plot " . curves[:strlen(curves) - 2] }
        unset label 1
    }
  }
  unset multiplot
  unset output
}
