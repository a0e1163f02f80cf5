"""The thresholds of a map: cells as boxes, and a grid for their contours."""

from rubplot import csv_table, domain_map, heading, map_axes
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand


def read_cells(path, across, up, natural_frequency_hz=None):
    """[(x, y, threshold)]; the threshold is None where rub goes on after no number of the scan."""
    cells = []
    for row in csv_table.read_table(path, across, up, "threshold"):
        if row[up]:
            x = csv_table.number(row, across) / (natural_frequency_hz or 1)
            cells.append((x, csv_table.number(row, up), csv_table.number(row, "threshold")))
    if all(threshold is None for _, _, threshold in cells):
        raise csv_table.TableError(f"{path}: no cell has a threshold")
    return cells


def box_lines(cells, logarithmic=(False, False)):
    """One line per cell: x y left right bottom top threshold, `NaN` without one; which axes are logarithmic."""
    sides = [domain_map.edges((cell[k] for cell in cells), logarithmic[k]) for k in (0, 1)]
    for x, y, threshold in cells:
        yield " ".join(_digits(value) for value in (x, y, *sides[0][x], *sides[1][y], threshold))


def grid_lines(cells):
    """Blocks of x y threshold, one for each x: what gnuplot draws contours of."""
    values = {(x, y): threshold for x, y, threshold in cells}
    rows = sorted({y for _, y in values})
    for x in sorted({x for x, _ in values}):
        for y in rows:
            yield " ".join(_digits(value) for value in (x, y, values.get((x, y))))
        yield ""


def levels(cells):
    """Where contours are drawn: 1, 2 and 5 times powers of ten between the smallest and the largest threshold."""
    found = [threshold for _, _, threshold in cells if threshold is not None]
    powers = [mantissa * 10.0**exponent for exponent in range(-12, 13) for mantissa in (1, 2, 5)]
    return [level for level in powers if min(found) < level < max(found)]


def _digits(value):
    return "NaN" if value is None else "%.17g" % value


def picture(given):
    plane = map_axes.read_plane(given.source)
    cells = read_cells(plane.map_file, plane.across, plane.up, plane.natural_hz)
    axes = plane.axes(max(y for _, y, _ in cells))
    cells = [(axes[0].factor * x, axes[1].factor * y, threshold) for x, y, threshold in cells]
    scales = map_axes.logarithmic(axes, [x for x, _, _ in cells], [y for _, y, _ in cells])
    # The first one of keys that are tied together.
    key = plane.config.get("study.key") or plane.config.get("study.keys", "threshold").strip("[]").split(",")[0]
    return Picture(
        "threshold.gp",
        (
            heading.text(given.heading, plane.config),
            map_axes.label(axes[0]),
            map_axes.label(axes[1]),
            key.replace("_", r"\_"),
            ",".join("%.17g" % level for level in levels(cells)),
            map_axes.scale_words(scales),
        ),
        {"cells": [*box_lines(cells, scales), "\n", *grid_lines(cells)]},
    )


SUBCOMMAND = Subcommand(
    name="threshold",
    summary="thresholds of a map that was made with study.kind threshold, with contours",
    description="""Draws the smallest kick after which rub goes on, for each cell of a map that was made with
study.kind threshold, over the same axes as `rubplot map`, with contours.""",
    source="DIR|MAP.csv",
    heading="Smallest kick after which rub goes on",
    picture=picture,
    units=("speed",),
    examples=("results/benchmark/threshold_one_side", "results/benchmark/threshold_one_side/map.csv --output threshold.svg"),
)
