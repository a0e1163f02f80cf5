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
        map_heading.heading(arguments[2], line.config, varied=(line.along,)),
        line.kinds,
        " ".join(line.passes),
        line.label,
        line.clearance_mm(),
        "towards the wall" if line.has_fixed_wall() else "y",
        "log" if line.is_logarithmic else "",
    )


if __name__ == "__main__":
    run_program(main, usage="bifurcation.sh DIR OUTPUT_BASENAME HEADING", least=3, most=3)
