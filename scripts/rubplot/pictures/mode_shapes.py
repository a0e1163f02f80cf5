"""Mode shapes in three dimensions: the orbit of each place of the shaft, and the shaft at one instant."""

import os
from itertools import groupby

from rubplot import captions, configuration, report_tables, shown_units, whirl_shapes
from rubplot.failure import Failure
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

MOST_SHAPES = 6


def picture(given):
    directory = given.source
    path = os.path.join(directory, "mode_shapes.csv")
    rows = report_tables.numbers(path, "mode", "speed_hz", "frequency_hz", "position_m", "x_real", "x_imag", "y_real", "y_imag")
    config = configuration.read_configuration(report_tables.path_of(directory, "config.yaml"))
    modes = [list(points) for _, points in groupby(rows, key=lambda row: row["mode"])]
    modes = [points for points in modes if len(points) > 1][:MOST_SHAPES]
    if not modes:
        raise Failure(f"{path}: there is no shaft whose shape could be drawn")
    shapes = [whirl_shapes.turned(whirl_shapes.shape_of(points)) for points in modes]
    files = {}
    for number, shape in enumerate(shapes):
        files[f"line_{number}"] = whirl_shapes.line_lines(shape)
        files[f"orbits_{number}"] = whirl_shapes.orbit_lines(shape)
    return Picture(
        "mode_shapes.gp",
        (captions.headed(given.heading, config), captions.byline(config), str(len(modes))),
        {
            **files,
            "labels.gp": [
                f"from = {1e3 * shapes[0][0][0]:.17g}",
                f"to = {1e3 * shapes[0][-1][0]:.17g}",
                f"right = {whirl_shapes.RIGHT:.17g}",
                f"up = {whirl_shapes.UP:.17g}",
                *(f"name_{i} = '{name_of(points[0], config)}'" for i, points in enumerate(modes)),
            ],
        },
        ("shaft_view.gp",),
    )


def name_of(row, config):
    """Number, frequency, direction and speed of a mode; a critical one has its speed as its frequency."""
    speed, frequency = row["speed_hz"], row["frequency_hz"]
    if abs(speed - frequency) <= 1e-6 * frequency:
        return "mode %d, critical at %s, %s" % (row["mode"], shown_units.speed_text(config, speed), row["whirl"])
    return "mode %d, %.4g Hz at %s, %s" % (row["mode"], frequency, shown_units.speed_text(config, speed), row["whirl"])


SUBCOMMAND = Subcommand(
    name="mode-shapes",
    summary="mode shapes in three dimensions (rubtrace --campbell, --rotor-report)",
    description="""Draws the mode shapes that rubtrace --campbell or --rotor-report wrote into DIR in three dimensions: orbits along
the shaft, and the shaft at the instant of its largest deflection.""",
    source="DIR",
    heading="Mode shapes",
    picture=picture,
    units=("speed",),
    examples=("results/my_rotor", "results/my_rotor --output modes.pdf"),
)
