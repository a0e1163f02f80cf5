"""The program behind curve_figure.sh, which says what it does."""

import os

import configuration
import csv_table
import curve_layout
import domain_map
import gnuplot
import map_heading
import swept_axes
from command import require_readable, run_program


def map_cells(map_file, parameters):
    """The cells of a map in the plane of the curves."""
    config_file = os.path.join(os.path.dirname(map_file), "config.yaml")
    require_readable(map_file, config_file)
    plane = swept_axes.plane(configuration.read_configuration(config_file))
    if tuple(plane) != tuple(parameters):
        raise csv_table.TableError(
            f"{map_file}: is a map over {' and '.join(plane)}, the curves are over {' and '.join(parameters)}"
        )
    return domain_map.read_cells(map_file, plane[1], None, plane[0])


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    directory, output = (os.path.abspath(name) for name in arguments[:2])
    curves = curve_layout.Curves(directory)
    config = configuration.read_configuration(os.path.join(directory, "config.yaml"))
    cells = map_cells(os.path.abspath(arguments[3]), curves.parameters) if len(arguments) > 3 else []
    marks = list(curves.mark_lines())
    files = {kind: curves.line_lines(kind) for kind in curves.kinds()}
    gnuplot.draw_files(
        "curve_figure.gp",
        files | {"meetings": marks, "cells": domain_map.cell_lines(cells)},
        output,
        map_heading.heading(arguments[2], config, varied=curves.parameters),
        " ".join(curves.kinds()),
        " ".join(sorted({cell.kind for cell in cells})),
        *curves.parameters,
        str(len(marks)),
    )


if __name__ == "__main__":
    run_program(main, usage="curve_figure.sh DIR OUTPUT_BASENAME HEADING [MAP.csv]", least=3, most=4)
