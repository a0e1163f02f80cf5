# Draws the cells that domain_map.awk lays out, one colour per class and order.
# gnuplot -c domain_map.gp CELLS OUTPUT_BASENAME HEADING PRESENT LABELS
# PRESENT: the kinds in CELLS, a blank around each; LABELS: x y text x y text ...

cells = ARG1
output = ARG2
heading = ARG3
present = ARG4
labels = ARG5

# Colours: Paul Tol's "muted" scheme, made for colour-blind readers. Three rare kinds are hatched.
array kind[16] = ["non_contact", "synchronous_circle", "synchronous", "subharmonic_2", "subharmonic_3", \
  "subharmonic_4", "subharmonic_5", "subharmonic_6", "subharmonic_7", "subharmonic_8", "quasi_periodic_comb", \
  "quasi_periodic", "chaotic", "unsettled", "initial_contact", "failed"]
array legend[16] = ["no contact", "synchronous circle", "synchronous", "subharmonic 1/2", "subharmonic 1/3", \
  "subharmonic 1/4", "subharmonic 1/5", "subharmonic 1/6", "subharmonic 1/7", "subharmonic ≤ 1/8", \
  "“synchronous oval”", \
  "quasi-periodic", "chaotic", "unsettled", "touches before kick", "failed"]
array colour[16] = ["#F4F4F4", "#4F9BD0", "#88CCEE", "#CC6677", "#332288", \
  "#DDCC77", "#117733", "#882255", "#44AA99", "#999933", "#EE8866", \
  "#AA4499", "#000000", "#555555", "#999999", "#CC0000"]
solid = ""
hatched = ""
do for [i = 1:16] {
  if (strstrt(present, " " . kind[i] . " ")) {
    if (i <= 13) { solid = solid . i . " " } else { hatched = hatched . i . " " }
  }
}

if (words(solid . hatched) != words(present)) { exit error "domain_map.gp: unknown class among:" . present }

stats cells index 0 using 3:5 name "LOW" nooutput
stats cells index 0 using 4:6 name "HIGH" nooutput
set xrange [LOW_min_x:HIGH_max_x]
set yrange [LOW_min_y:HIGH_max_y]
do for [n = int(ceil(LOW_min_x)):int(floor(HIGH_max_x))] {
  set arrow from n, graph 0 to n, graph 1 nohead front dashtype 2 linewidth 1.5 linecolor rgb "#444444"
}

set style textbox opaque noborder margins 0.4, 0.4
do for [k = 1:words(labels):3] {
  set label word(labels, k + 2) at real(word(labels, k)), real(word(labels, k + 1)) center front boxed font ",16"
}

set title heading
set xlabel "shaft speed / natural frequency"
set ylabel "whirl ratio (quiet whirl / clearance)"
set xtics 1 out nomirror
set mxtics 2
set ytics out nomirror
set key at screen 0.775, graph 1 left top Left reverse samplen 1.5 spacing 1.4
set rmargin at screen 0.76
at(list, k) = k > words(list) ? 16 : int(word(list, k))  # gnuplot reads the body of an empty loop, too
x_if(i) = strcol(7) eq kind[i] ? $1 : NaN

set terminal pngcairo size 1600, 1000 font "DejaVu Sans,20" linewidth 1.5
set output output . ".png"
plot for [k = 1:words(solid)] cells index 0 using (x_if(at(solid, k))):2:3:4:5:6 with boxxyerror \
       linecolor rgb colour[at(solid, k)] linewidth 0.5 fillstyle solid 1 border title legend[at(solid, k)], \
     for [k = 1:words(hatched)] cells index 0 using (x_if(at(hatched, k))):2:3:4:5:6 with boxxyerror \
       linecolor rgb colour[at(hatched, k)] linewidth 0.5 fillstyle pattern (at(hatched, k) - 10) border \
       title legend[at(hatched, k)]
set terminal svg size 1600, 1000 font "DejaVu Sans,20" linewidth 1.5
set output output . ".svg"
replot
