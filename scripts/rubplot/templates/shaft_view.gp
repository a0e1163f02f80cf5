# The view of a whirling shaft along the axis of the picture; stands before the templates that show one.
# shaft_view: the commands that set its axes and show where x and y point; from, to, right and up are those of whirl_shapes.py.
shaft_view = "set xrange [from - 2.3 * right * (to - from):to + 1.2 * right * (to - from)]; set yrange [-1.25:1.25]; " . \
  "set border 1; unset ytics; unset mytics; set xtics nomirror out; " . \
  "set arrow 1 from first from, first 0 to first to, first 0 nohead dashtype 4 linewidth 0.8 linecolor rgb '#777777' back; " . \
  "set arrow 2 from graph 0.015, first -1.05 rto graph 0, first 0.3 size graph 0.008, 20 linewidth 1 linecolor rgb '#555555'; " . \
  "set arrow 3 from graph 0.015, first -1.05 rto first 0.35 * right * (to - from), first 0.35 * up size graph 0.008, 20 linewidth 1 " . \
  "linecolor rgb '#555555'; " . \
  "set label 11 'y' at graph 0.015, first -0.56 center font ',15'; " . \
  "set label 12 'x' at graph 0.015, first -1.05 right offset first 0.75 * right * (to - from), first 0.5 * up font ',15'"
