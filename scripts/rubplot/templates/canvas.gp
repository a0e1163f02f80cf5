# The pages that templates draw on; stands before each of them, behind the names of the formats.
# canvas(FORMAT, WIDTH, HEIGHT, FONT, LINES): the commands that begin picture.FORMAT, of so many pixels, which in a document
# are points; LINES: width of lines, of which those of a document have half.
canvas(format, width, height, font, lines) = (format eq "pdf" ? \
    sprintf("set terminal pdfcairo size %.6fin, %.6fin fontscale 1 font '%s' linewidth %g", width / 72.0, height / 72.0, \
      font, 2 * lines) : \
    sprintf("set terminal %s size %d, %d font '%s' linewidth %g", format eq "png" ? "pngcairo" : "svg", width, height, font, \
      lines)) . "; set output 'picture." . format . "'"
# rpm_above(LABEL): the commands that write revolutions per minute above a plot whose axis with this label is a shaft speed in
# Hz, and none where it is not; they want a range of that axis. no_rpm: those that take them away.
rpm_above(label) = strstrt(label, "shaft speed (Hz)") == 1 ? \
  "set link x2 via 60 * x inverse x / 60.0; set x2tics autofreq out nomirror format '%g' font ',16'; " . \
  "set label 990 'rpm' at graph 0, graph 1 right offset character -2.5, 1.5 font ',16'" : ""
no_rpm = "unset link x2; unset x2tics; unset label 990"
