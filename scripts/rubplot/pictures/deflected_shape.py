"""The deflected shape of a rotor under its unbalance at one speed: orbits along the shaft, and half of their major axis."""

import cmath
import math

from rubplot import captions, configuration, report_tables, shown_units, whirl_shapes
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand


def picture(given):
    directory = given.source
    path = report_tables.require(directory, "deflected_shape.csv", "deflected_shape")
    rows = report_tables.numbers(path, "position_m", "x_real", "x_imag", "y_real", "y_imag")
    config = configuration.read_configuration(report_tables.path_of(directory, "config.yaml"))
    shape = whirl_shapes.turned(whirl_shapes.shape_of(rows))
    scale, unit = shown_units.of_amplitude(whirl_shapes.largest(shape))
    bearings = report_tables.bearings(directory)
    return Picture(
        "deflected_shape.gp",
        (captions.headed(given.heading, config), captions.byline(config), unit, report_tables.note_text(directory, "deflected_shape")),
        {
            "line": whirl_shapes.line_lines(shape) if len(shape) > 1 else ["0 0"],
            "orbits": whirl_shapes.orbit_lines(shape) if len(shape) > 1 else plain_orbit(shape[0], scale),
            "amplitude": ("%.17g %.17g" % (1e3 * position, scale * whirl_shapes.major(x, y)) for position, x, y in shape),
            "bearings": [*("%.17g" % (1e3 * position) for _, position in bearings), "-1e9"],
            "labels.gp": [
                f"from = {1e3 * shape[0][0]:.17g}",
                f"to = {1e3 * shape[-1][0]:.17g}",
                f"right = {whirl_shapes.RIGHT:.17g}",
                f"up = {whirl_shapes.UP:.17g}",
                f"largest = {scale * whirl_shapes.largest(shape):.17g}",
                f"any_shaft = {len(shape) > 1:d}",
                f"any_bearings = {len(bearings) > 0:d}",
            ],
        },
        ("shaft_view.gp",),
    )


def plain_orbit(place, scale):
    """The orbit of a single place as x and y."""
    _, x, y = place
    turns = [cmath.exp(2j * math.pi * part / whirl_shapes.PARTS) for part in range(whirl_shapes.PARTS + 1)]
    return ["%.17g %.17g" % (scale * (x * turn).real, scale * (y * turn).real) for turn in turns]


SUBCOMMAND = Subcommand(
    name="deflected-shape",
    summary="orbits along the shaft and its deflected shape at one speed",
    description="""Draws the unbalance response that rubtrace --rotor-report wrote into DIR: the orbits along the shaft at one
speed, the shaft at the instant of its largest deflection, and half of the major axis of the orbits.""",
    source="DIR",
    heading="Deflected shape",
    picture=picture,
    units=("length", "peak_to_peak"),
    examples=("results/my_rotor", "results/my_rotor --output shape.svg --length-unit um"),
)
