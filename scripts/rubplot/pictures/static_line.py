"""A rotor at rest: the line it hangs in, shear force and bending moment, and the loads of its bearings."""

import os

from rubplot import captions, configuration, gnuplot_text, lanes, report_tables
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

LETTER = 0.0076  # width of a letter as a share of the axis
PLANES = ("x", "y")


def picture(given):
    directory = given.source
    path = report_tables.require(directory, "static_line.csv", "static_line")
    columns = [f"{name}_{plane}_{unit}" for name, unit in (("deflection", "m"), ("shear", "n"), ("moment", "nm")) for plane in PLANES]
    rows = report_tables.numbers(path, "position_m", *columns)
    config = configuration.read_configuration(report_tables.path_of(directory, "config.yaml"))
    length = rows[-1]["position_m"] - rows[0]["position_m"]
    loads = bearing_loads(os.path.join(directory, "bearing_loads.csv"))
    labels = lanes.lay_out([((load["position_m"] - rows[0]["position_m"]) / length, text_of(load)) for load in loads], LETTER)
    forces = rows[0]["moment_y_nm"] is not None
    return Picture(
        "static_line.gp",
        (captions.headed(given.heading, config), captions.byline(config)),
        {
            "line": curve_lines(rows, columns),
            "bearings": [*("%.17g" % (1e3 * load["position_m"]) for load in loads), "-1e9"],
            "labels.gp": [
                f"from = {1e3 * rows[0]['position_m']:.17g}",
                f"to = {1e3 * rows[-1]['position_m']:.17g}",
                f"any_forces = {forces:d}",
                f"any_x = {moves(rows, 'deflection_x_m', 'deflection_y_m'):d}",
                f"rows = {lanes.rows(labels)}",
                *load_lines(labels),
            ],
        },
    )


def bearing_loads(path):
    return report_tables.numbers(path, "position_m", "load_x_n", "load_y_n") if os.path.exists(path) else []


def text_of(load):
    """Name and load of a bearing, with its direction where that is not the one of the weight."""
    x, y = load["load_x_n"], load["load_y_n"]
    size = (x * x + y * y) ** 0.5
    if abs(x) > 1e-6 * size:
        return "%s: %.4g N (x %.4g, y %.4g)" % (load["bearing"], size, x, y)
    return "%s: %.4g N%s" % (load["bearing"], size, "" if y <= 0 else " upwards")


def moves(rows, name, other):
    """Whether a column is more than rounding beside another."""
    largest = max(abs(row[other]) for row in rows)
    return max(abs(row[name]) for row in rows) > 1e-9 * largest


def curve_lines(rows, columns):
    """Place in mm, deflections in µm, forces in N and moments in N m; 0 where there are none."""
    for row in rows:
        values = [row[name] or 0.0 for name in columns]
        yield " ".join("%.17g" % value for value in (1e3 * row["position_m"], 1e6 * values[0], 1e6 * values[1], *values[2:]))


def load_lines(labels):
    """The loads of the bearings above the picture, each with a line down to its place."""
    for label in labels:
        yield (f"set label {gnuplot_text.quoted(label.text)} at graph {label.middle:.17g}, graph {1.1 + 0.13 * label.row:.17g} center "
               "noenhanced front font ',17' boxed")
        yield (f"set arrow from graph {label.at:.17g}, graph 1 to graph {label.middle:.17g}, graph {1.05 + 0.13 * label.row:.17g} "
               "nohead linewidth 0.7 linecolor rgb '#AAAAAA' back")


SUBCOMMAND = Subcommand(
    name="static-line",
    summary="a rotor at rest: deflection, shear force, bending moment, bearing loads",
    description="""Draws the static line that rubtrace --rotor-report wrote into DIR: what a shaft on its bearings does under its
weight and constant loads. A moment above 0 makes the shaft sag.""",
    source="DIR",
    heading="Static line",
    picture=picture,
    examples=("results/my_rotor", "results/my_rotor --output static.pdf"),
)
