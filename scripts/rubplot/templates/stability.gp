# Draws the stability that pictures/stability.py lays out.
# Arguments: HEADING BYLINE SPEED_LABEL COUPLING_LABEL NOTE
# Files: modes, coupling and labels.gp.

# Colours: Paul Tol's "muted" scheme, made for colour-blind readers.
array colour[3] = ["#332288", "#CC6677", "#999933"]
array direction[3] = ["forward whirl", "backward whirl", "neither way"]
array dash[3] = [1, 2, 4]

do for [format in formats] {
  eval canvas(format, 2000, 900, 'DejaVu Sans,20', 1.5)
  reset
  set encoding utf8
  set minussign
  set style textbox opaque noborder fillcolor rgb "white" margins 0.3, 0.1
  set multiplot
  set label 1000 ARG1 at screen 0.5, 0.967 center font ":Bold,24" noenhanced
  set label 1003 ARG2 at screen 0.995, 0.018 right font ",13" noenhanced
  load "labels.gp"
  set lmargin at screen 0.075
  set rmargin at screen (any_coupling ? 0.52 : 0.93)
  set bmargin at screen (ARG2 eq "" ? 0.125 : 0.15)
  set tmargin at screen 0.79
  set border 3
  set tics nomirror out
  set xrange [slowest:fastest]
  set yrange [low:high]
  eval rpm_above(ARG3)
  set xlabel ARG3
  set label 1004 "logarithmic decrement" at screen 0.014, 0.47 center rotate by 90
  set key at screen 0.075, screen 0.94 left top horizontal Left reverse noopaque samplen 2 maxrows 1
  set object 1 rectangle from graph 0, graph 0 to graph 1, first 0 behind fillcolor rgb "#F6DDDD" fillstyle solid noborder
  set arrow 1 from graph 0, first 0 to graph 1, first 0 nohead linewidth 1.2 linecolor rgb "#AA3311"
  set arrow 2 from graph 0, first 0.1 to graph 1, first 0.1 nohead dashtype 3 linewidth 1 linecolor rgb "#777777"
  if (!any_coupling) {
    set label 1005 ARG5 at screen 0.93, 0.887 right font ",13" noenhanced
  }
  plot for [k = 1:(any_mixed ? 3 : 2)] "modes" using 1:($3 == k - 1 ? $2 : NaN) with lines linecolor rgb colour[k] dashtype dash[k] \
      linewidth 2.2 title direction[k], \
    NaN with lines dashtype 3 linewidth 1 linecolor rgb "#777777" title "0.1 (API 617)"
  unset label
  eval no_rpm

  if (any_coupling) {
    set lmargin at screen 0.67
    set rmargin at screen 0.975
    set xrange [*:*]
    set yrange [*:*]
    set offsets graph 0, graph 0.02, graph 0.08, graph 0.05
    set xlabel ARG4
    set label 1004 "logarithmic decrement" at screen 0.585, 0.47 center rotate by 90
    set label 1005 ARG5 at graph 0.5, graph 1.06 center font ",16" noenhanced
    if (zero >= 0) {
      set label 1006 sprintf("%.4g", zero) at first zero, first 0 left offset 0.8, 1 boxed front point pointtype 7 pointsize 1.3 linecolor rgb "#AA3311"
    }
    unset key
    plot "coupling" using 1:2 with lines linewidth 2.5 linecolor rgb colour[1] notitle
  }
  unset multiplot
  unset output
}
