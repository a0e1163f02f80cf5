# Draws the cascade of full spectra that pictures/cascade.py lays out: a panel for each pass.
# Arguments: HEADING PRESENT PASSES LABEL RANGE SCALE
# Files: for each pass its spectra, the largest value first, and kinds.gp; PRESENT: the kinds, a blank around each;
# RANGE: the least and the largest value; SCALE: largest order, largest amplitude in mm, height of a millimetre.

heading = ARG1
present = ARG2
passes = ARG3
y_label = ARG4
least = real(word(ARG5, 1))
largest = real(word(ARG5, 2))
order = int(word(ARG6, 1))
highest = real(word(ARG6, 2))
height = real(word(ARG6, 3))
# Lines want more contrast than areas.
colour[1] = "#AAAAAA"

shown = ""
do for [i = 1:kinds] { if (strstrt(present, " " . kind[i] . " ")) { shown = shown . i . " " } }
if (words(shown) != words(present)) { exit error "cascade.gp: unknown class among:" . present }
at(k) = int(word(shown, k))
legend_of(name) = name eq "kick" ? "from the kick" : name eq "up" ? "upward" : "downward"

span = largest - least
load "kinds.gp"
kinds_of(name) = value("kinds_" . name)
number_of(name) = sum [i = 1:kinds] (kind[i] eq name ? i : 0)
power = 10.0**floor(log10(highest))
bar = highest >= 5 * power ? 5 * power : highest >= 2 * power ? 2 * power : power

panels = words(passes)
panel_px = panels > 1 ? 760 : 1080
width = 150 + panels * (panel_px + 40) + 400
x_at(px) = real(px) / width

do for [format in formats] {
  eval canvas(format, width, 1200, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set tics nomirror out
  set bmargin at screen 0.10
  set tmargin at screen 0.84
  set xrange [-order - 0.3:order + 0.3]
  set yrange [least - 0.02 * span:largest + height * highest + 0.03 * span]
  set xtics 1
  if (strlen(value_ticks)) { eval "set ytics (" . value_ticks . ")" }
  set grid xtics linecolor rgb "#E4E4E4"
  set xlabel "order (× shaft speed)"
  set label 1 heading at screen x_at(150 + 0.5 * panels * (panel_px + 40)), 0.97 center
  do for [i = 1:panels] {
    set lmargin at screen x_at(150 + (i - 1) * (panel_px + 40))
    set rmargin at screen x_at(150 + (i - 1) * (panel_px + 40) + panel_px)
    # Not as the label of the axis: beside a fixed margin it may come over the numbers.
    if (i == 1) { set label 6 y_label at screen x_at(22), 0.47 center rotate by 90 noenhanced } else { set format y "" }
    set label 2 "backward" at graph 0.02, 0.97 left font ",16"
    set label 3 "forward" at graph 0.98, 0.97 right font ",16"
    set label 4 legend_of(word(passes, i)) at graph 0.5, 0.97 center font ":Bold"
    if (i == panels) {
      set key at screen x_at(150 + panels * (panel_px + 40)), graph 1 left top Left reverse samplen 1 spacing 1.4
      set arrow 1 from graph 1.03, first least to graph 1.03, first least + bar * height nohead linewidth 3
      set label 5 sprintf("%g mm", bar) at graph 1.05, first least + 0.5 * bar * height left
    } else { unset key }
    name = word(passes, i)
    # From the back to the front: each hides what is behind it.
    plot for [k = 1:words(kinds_of(name))] name index (k - 1) using 1:2 with filledcurves closed \
        fillcolor rgb "white" fillstyle solid 1 border linecolor rgb colour[number_of(word(kinds_of(name), k))] notitle, \
      for [k = 1:words(shown)] NaN with points pointtype 5 pointsize 1.6 linecolor rgb colour[at(k)] title legend[at(k)]
    unset label 1
    unset label 6
    unset arrow 1
    unset label 5
  }
  unset multiplot
  set format y "% h"
  unset label
  unset output
}
