# Draws the static line that pictures/static_line.py lays out.
# Arguments: HEADING BYLINE
# Files: line, bearings and labels.gp.

array colour[2] = ["#CC6677", "#332288"]
array name[3] = ["deflection (µm)", "shear force (N)", "bending moment (N m)"]

do for [format in formats] {
  eval canvas(format, 2000, 1200, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set multiplot
  set style textbox opaque noborder fillcolor rgb "white" margins 0.3, 0.1
  load "labels.gp"
  panels = any_forces ? 3 : 1
  low = ARG2 eq "" ? 0.09 : 0.11
  # Room above the first panel for the rows of loads, whose height is a share of that panel.
  height = (0.87 - low) / (panels + 0.13 * (rows + 0.6) + 0.12 * (panels - 1))
  set label 1000 ARG1 at screen 0.5, 0.972 center font ":Bold,24" noenhanced
  set label 1003 ARG2 at screen 0.995, 0.015 right font ",13" noenhanced
  set lmargin at screen 0.095
  set rmargin at screen 0.97
  set border 3
  set tics nomirror out
  set xrange [from:to]
  set yrange [*:*]
  set offsets 0, 0, graph 0.08, graph 0.08
  set xzeroaxis linewidth 0.7 linecolor rgb "#999999"
  set key at screen 0.985, screen 0.94 right top horizontal Left reverse noopaque samplen 2 maxrows 1
  do for [panel = 1:panels] {
    top = low + (panels - panel + 1) * height + (panels - panel) * 0.12 * height
    set tmargin at screen top
    set bmargin at screen top - height
    set format x (panel == panels ? "%g" : "")
    if (panel == panels) { set xlabel "place along the shaft (mm)" }
    set label 1004 name[panel] at screen 0.014, screen (top - height / 2) center rotate by 90
    plot for [plane = (any_x ? 1 : 2):2] "line" using 1:(column(2 * panel + plane - 1)) with lines linewidth 2.5 linecolor rgb colour[plane] \
        title (panel == 1 && any_x ? (plane == 1 ? "x" : "y") : ""), \
      "bearings" using 1:(0) with points pointtype 9 pointsize 2 linecolor rgb "#117733" title (panel == 1 && rows > 0 ? "bearing" : "")
    unset label
    unset arrow
    unset key
  }
  unset multiplot
  unset output
}
