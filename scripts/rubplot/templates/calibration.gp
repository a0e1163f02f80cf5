# Draws the calibration that pictures/calibration.py lays out.
# Arguments: HEADING
# Files: statements (mean, share that is right, half of its 95 % interval, number), firsts (place of the answer, place of the
# truth from the top, number, share), ranks (blocks of each number: middle of the part, count over the expected one).

heading = ARG1
blue = "#332288"
green = "#117733"
grey = "#888888"
load "settings.gp"  # answer[], truth[], number[], band

do for [format in formats] {
  eval canvas(format, 1900, 820, 'DejaVu Sans,17', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set label 1 heading at screen 0.5, 0.965 center font ":Bold,20" noenhanced
  set tics nomirror out
  set grid linecolor rgb "#E4E4E4"
  unset key

  set tmargin at screen 0.86
  set bmargin at screen 0.20
  set lmargin at screen 0.06
  set rmargin at screen 0.33
  set title "Statements"
  set xrange [0:100]
  set yrange [0:108]
  set xlabel "stated probability (%)"
  set ylabel "share that is right (%)"
  plot x with lines linecolor rgb grey dashtype 2, \
    "statements" using (100 * $1):(100 * $2):(100 * $3) with yerrorbars pointtype 7 pointsize 1.2 linewidth 1.5 \
      linecolor rgb blue, \
    "statements" using (100 * $1):(100 * $2):4 with labels offset 2.2, -0.9 font ",12" textcolor rgb grey
  unset label 1

  set lmargin at screen 0.47
  set rmargin at screen 0.68
  set title "Answer that came first"
  unset xlabel
  unset ylabel
  unset grid
  set xrange [-0.5:|answer| - 0.5]
  set yrange [-|truth| + 0.5:0.5]
  set xtics rotate by -40 noenhanced scale 0
  set ytics noenhanced scale 0
  set xtics ()
  set ytics ()
  do for [i = 1:|answer|] { set xtics add (answer[i] i - 1) }
  do for [i = 1:|truth|] { set ytics add (truth[i] 1 - i) }
  set cbrange [0:1]
  set palette defined (0 "#FFFFFF", 1 "#44AA99")
  unset colorbox
  plot "firsts" using 1:2:4 with image, \
    "" using 1:2:(strcol(3) eq "0" ? "" : strcol(3)) with labels
  set grid linecolor rgb "#E4E4E4"

  set lmargin at screen 0.75
  set rmargin at screen 0.98
  set title "True numbers in their posteriors"
  set xtics norotate autofreq scale 1
  set ytics autofreq scale 1
  set xrange [0:1]
  set yrange [0:*]
  set xlabel "share of the posterior below"
  set ylabel "count / expected count"
  set key at screen 0.865, screen 0.085 center top horizontal maxrows 3 maxcols 3 samplen 1 width -2 font ",12" noenhanced
  set arrow 1 from 0, 1 + band to 1, 1 + band nohead dashtype 2 linecolor rgb grey
  set arrow 2 from 0, 1 - band to 1, 1 - band nohead dashtype 2 linecolor rgb grey
  plot for [i = 1:|number|] "ranks" index i - 1 using 1:2 with linespoints linewidth 1.5 pointtype i \
    linecolor rgb word("#332288 #88CCEE #44AA99 #117733 #999933 #DDCC77 #CC6677 #882255 #AA4499", 1 + (i - 1) % 9) title number[i]
  unset arrow
  unset multiplot
}
