# The pages that templates draw on; stands before each of them, behind the names of the formats.
# canvas(FORMAT, WIDTH, HEIGHT, FONT, LINES): the commands that begin picture.FORMAT, of so many pixels, which in a document
# are points; LINES: width of lines, of which those of a document have half.
canvas(format, width, height, font, lines) = (format eq "pdf" ? \
    sprintf("set terminal pdfcairo size %.6fin, %.6fin fontscale 1 font '%s' linewidth %g", width / 72.0, height / 72.0, \
      font, 2 * lines) : \
    sprintf("set terminal %s size %d, %d font '%s' linewidth %g", format eq "png" ? "pngcairo" : "svg", width, height, font, \
      lines)) . "; set output 'picture." . format . "'"
