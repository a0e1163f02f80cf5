"""A bifurcation diagram: section points and largest displacement along a line, by kind of motion."""

from rubplot import csv_table, heading, shown_units
from rubplot.gnuplot import Picture
from rubplot.line_tables import PASSES, Line, number
from rubplot.subcommand import Subcommand


def section_lines(line):
    """Value, displacement towards the wall in the unit of the picture, number of the pass, kind."""
    x, y = line.towards_wall()
    for row in csv_table.read_table(line.files["bifurcation.csv"], "pass", "value", "x_m", "y_m"):
        displacement = x * number(row, "x_m") + y * number(row, "y_m")
        yield f"{line.value(row):.17g} {shown_units.millimetres()[0] * displacement:.17g} {PASSES.index(row['pass'])} {line.kind(row)}"


def peak_lines(line):
    """Value, largest displacement in the unit of the picture, number of the pass; a block for each pass."""
    for name in line.passes:
        for row in line.cells:
            peak = csv_table.number(row, "peak_displacement_m")
            if row["pass"] == name and peak is not None:
                yield f"{line.value(row):.17g} {shown_units.millimetres()[0] * peak:.17g} {PASSES.index(name)}"
        yield ""


def picture(given):
    line = Line(given.source)
    return Picture(
        "line.gp",
        (
            heading.text(given.heading, line.config, varied=(line.along,)),
            line.kinds,
            " ".join(line.passes),
            line.label,
            line.clearance(),
            "towards the wall" if line.has_fixed_wall() else "y",
            "logx" if line.is_logarithmic else "",
            shown_units.millimetres()[1],
        ),
        {"section": section_lines(line), "peaks": peak_lines(line)},
        ("motion_kinds.gp",),
    )


SUBCOMMAND = Subcommand(
    name="line",
    summary="bifurcation diagram of what rubline wrote",
    description="""Draws what rubline wrote into DIR: section points and largest displacement along the line, coloured by the
kind of motion.""",
    source="DIR",
    heading="Bifurcation diagram",
    picture=picture,
    units=("speed", "length"),
    examples=("results/my_line", "results/my_line --output bifurcation.pdf --heading 'From 118 to 160 Hz'"),
)
