"""The program behind cascade.sh, which says what it does."""

import os
import tempfile

import gnuplot
import line_layout
import map_heading
from command import Failure, run_program

# Of the largest line, as a share of the whole line of cells.
HEIGHT = 0.16


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    directory, output = (os.path.abspath(name) for name in arguments[:2])
    line = line_layout.Line(directory)
    spectra = line_layout.spectra(line)
    highest = line_layout.largest_amplitude(spectra)
    if highest == 0:
        raise Failure(f"{line.files['cascade.csv']}: no line of a spectrum")
    values = [float(cell["value"]) for cell in line.cells]
    span = max(values) - min(values) or 1.0
    order = line_layout.largest_order(spectra)
    height = HEIGHT * span / highest
    with tempfile.TemporaryDirectory() as work:
        for name, of_pass in spectra.items():
            with open(os.path.join(work, name), "w", encoding="utf-8") as file:
                for spectrum in of_pass:
                    file.writelines("%.17g %.17g\n" % point for point in spectrum.outline(order + 0.3, height))
                    file.write("\n\n")
        with open(os.path.join(work, "kinds.gp"), "w", encoding="utf-8") as file:
            for name, of_pass in spectra.items():
                file.write(f"kinds_{name} = \"{' '.join(spectrum.kind for spectrum in of_pass)}\"\n")
        os.makedirs(os.path.dirname(output), exist_ok=True)
        gnuplot.draw(
            "cascade.gp",
            work,
            output,
            map_heading.heading(arguments[2], line.config),
            line.kinds,
            " ".join(line.passes),
            line.label,
            "%.17g %.17g" % (min(values), min(values) + span),
            "%d %.17g %.17g" % (order, highest, height),
        )


if __name__ == "__main__":
    run_program(main, usage="cascade.sh DIR OUTPUT_BASENAME HEADING", least=3, most=3)
