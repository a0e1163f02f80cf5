"""Lays out the table of rubbench for work_precision.gp: blocks of points by cell, contact handling, stepper and method."""

import re

import csv_table
from command import Failure


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
        yield f"# {name}\n"
        for time, error in points:
            yield f"{_digits(time)} {_digits(error)}\n"
        yield "\n\n"


def settings(chart):
    """What work_precision.gp loads: titles of the cells, ends of the axes, and which blocks there are."""
    yield f"array cell_title[{len(chart.titles)}]\n"
    for i, title in enumerate(chart.titles, 1):
        yield f"cell_title[{i}] = {quoted(title)}\n"
    yield "low_time = %g\nhigh_time = %g\n" % (min(chart.times) / 2, max(chart.times) * 2)
    yield "low_error = %g\nhigh_error = %g\n" % (min(chart.errors) / 3, max(chart.errors) * 3)
    yield f"known = {quoted(' ' + ''.join(name + ' ' for name in chart.blocks))}\n"
    yield 'has(name) = strstrt(known, " " . name . " ") > 0\n'


def quoted(text):
    """`text` as gnuplot reads it between single quotes, where it knows one escape."""
    return "'" + re.sub(r"[\x00-\x1f\x7f]", "?", text).replace("'", "''") + "'"


def _digits(value):
    return "%d" % value if value == int(value) else "%.6g" % value
