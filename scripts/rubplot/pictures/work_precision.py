"""The table of rubbench: blocks of points by cell, contact handling, stepper and method."""

import os

from rubplot import captions, csv_table
from rubplot.failure import Failure, require_readable
from rubplot.gnuplot import Picture
from rubplot.gnuplot_text import quoted
from rubplot.subcommand import Subcommand


class Chart:
    """Points of error against time, in the order in which they are found."""

    def __init__(self):
        self.titles = []  # of the cells
        self.blocks = {}  # name of a curve -> list of (time, error)
        self.times = []
        self.errors = []

    def add(self, name, time, error):
        self.blocks.setdefault(name, []).append((time, error))


def read_chart(path):
    """Reads every run that has a time and an error. The exact solver without a stepper is a single point, drawn in both columns."""
    chart = Chart()
    names = ("cell", "method", "stepper", "contact", "microseconds_per_revolution", "state_error")
    for row in csv_table.read_table(path, *names):
        time, error = csv_table.number(row, "microseconds_per_revolution"), csv_table.number(row, "state_error")
        if time is None or error is None:
            continue
        if row["cell"] not in chart.titles:
            chart.titles.append(row["cell"])
        if time <= 0 or error <= 0:
            continue
        chart.times.append(time)
        chart.errors.append(error)
        cell, stepper = chart.titles.index(row["cell"]) + 1, row["stepper"] or "exact"
        chart.add(f"{cell}_{row['contact']}_{stepper}_{row['method']}", time, error)
        if stepper == "exact":
            chart.add(f"{cell}_smoothed_exact_exact", time, error)
    if not chart.times:
        raise Failure("no run to draw")
    return chart


def data_lines(chart):
    """The blocks as gnuplot reads them, each under its name."""
    for name, points in chart.blocks.items():
        yield f"# {name}"
        yield from (f"{_digits(time)} {_digits(error)}" for time, error in points)
        yield "\n"


def settings(chart):
    """Assignments for the template: titles of the cells, ends of the axes, and which blocks there are."""
    yield f"array cell_title[{len(chart.titles)}]"
    for i, title in enumerate(chart.titles, 1):
        yield f"cell_title[{i}] = {quoted(title)}"
    yield "low_time = %g\nhigh_time = %g" % (min(chart.times) / 2, max(chart.times) * 2)
    yield "low_error = %g\nhigh_error = %g" % (min(chart.errors) / 3, max(chart.errors) * 3)
    yield f"known = {quoted(' ' + ''.join(name + ' ' for name in chart.blocks))}"
    yield 'has(name) = strstrt(known, " " . name . " ") > 0'


def _digits(value):
    return "%d" % value if value == int(value) else "%.6g" % value


def picture(given):
    table = os.path.join(given.source, "work_precision.csv") if os.path.isdir(given.source) else given.source
    require_readable(table)
    chart = read_chart(table)
    own = captions.of_table(csv_table.head(table))
    return Picture(
        "work_precision.gp",
        (captions.headed(given.heading, own), str(len(chart.titles)), captions.byline(own)),
        {"data": data_lines(chart), "settings.gp": settings(chart)},
    )


SUBCOMMAND = Subcommand(
    name="work-precision",
    summary="error against time of every method (rubbench)",
    description="""Draws the table that rubbench wrote: error against processor time per revolution, a row of panels for every
cell. Variants that failed are left out.""",
    source="DIR|TABLE.csv",
    heading="Work against precision",
    picture=picture,
    examples=("results/work_precision/one_side.csv --output one_side.pdf", "results/my_bench"),
)
