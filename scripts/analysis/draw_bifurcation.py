"""The program behind bifurcation.sh, which says what it does."""

import os

import gnuplot
import line_layout
import map_heading
from command import run_program


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    directory, output = (os.path.abspath(name) for name in arguments[:2])
    line = line_layout.Line(directory)
    gnuplot.draw_files(
        "bifurcation.gp",
        {"section": line_layout.section_lines(line), "peaks": line_layout.peak_lines(line)},
        output,
        map_heading.heading(arguments[2], line.config),
        line.kinds,
        " ".join(line.passes),
        line.label,
        "%.17g" % (1e3 * line.clearance_m()),
        "towards the wall" if line.towards_wall() != (0.0, 1.0) or line.config["stops.0.kind"] == "one_side" else "y",
    )


if __name__ == "__main__":
    run_program(main, usage="bifurcation.sh DIR OUTPUT_BASENAME HEADING", least=3, most=3)
