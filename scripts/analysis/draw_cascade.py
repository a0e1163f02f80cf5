"""The program behind cascade.sh, which says what it does."""

import os

import gnuplot
import line_layout
import map_heading
from command import Failure, run_program

# Height of the largest line, as a share of the whole line of cells.
HEIGHT = 0.16


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    directory, output = (os.path.abspath(name) for name in arguments[:2])
    line = line_layout.Line(directory)
    spectra = line_layout.spectra(line)
    highest = line_layout.largest_amplitude(spectra)
    if highest == 0:
        raise Failure(f"{line.files['cascade.csv']}: no line of a spectrum")
    values = [line.value(cell) for cell in line.cells]
    span = max(values) - min(values) or 1.0
    order = line_layout.largest_order(spectra)
    height = HEIGHT * span / highest
    files = {name: _outlines(of_pass, order + 0.3, height) for name, of_pass in spectra.items()}
    files["kinds.gp"] = [f"kinds_{name} = \"{' '.join(s.kind for s in of_pass)}\"" for name, of_pass in spectra.items()]
    gnuplot.draw_files(
        "cascade.gp",
        files,
        output,
        map_heading.heading(arguments[2], line.config, varied=(line.along,)),
        line.kinds,
        " ".join(line.passes),
        line.label,
        "%.17g %.17g" % (min(values), min(values) + span),
        "%d %.17g %.17g" % (order, highest, height),
    )


def _outlines(spectra, largest_order, height):
    """A block of points for each spectrum, two empty lines behind it."""
    for spectrum in spectra:
        yield from ("%.17g %.17g" % point for point in spectrum.outline(largest_order, height))
        yield "\n"


if __name__ == "__main__":
    run_program(main, usage="cascade.sh DIR OUTPUT_BASENAME HEADING", least=3, most=3)
