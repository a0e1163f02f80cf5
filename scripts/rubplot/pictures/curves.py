"""Curves in two parameters: a line for every curve, marks at meetings, and the cells of a map behind them."""

import os

from rubplot import configuration, csv_table, domain_map, heading, map_axes, shown_units
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

COLUMNS = ("parameter", "curve_parameter")
# Names of meetings that are nearer than these shares of the curves' extents would stand on each other.
NAME_SIZE = (0.2, 0.05)
# Kinds of curves, in the order of the legend.
KINDS = ("fold", "period_doubling", "neimark_sacker", "branch_point", "graze")


class Curves:
    """The tables of one directory."""

    def __init__(self, directory):
        path = os.path.join(directory, "curves.csv")
        self._points = list(csv_table.read_table(path, "curve", "kind", "parameter", "curve_parameter"))
        if not self._points:
            raise csv_table.TableError(f"{path}: no curves")
        self._meetings = list(
            csv_table.read_table(os.path.join(directory, "meetings.csv"), "meeting", "parameter", "curve_parameter")
        )
        named = csv_table.head(path)
        self.parameters = tuple(named.get(name, name) for name in COLUMNS)
        self.config = configuration.read_configuration(os.path.join(directory, "config.yaml"))
        self.axes = tuple(shown_units.axis(self.config, parameter) for parameter in self.parameters)

    def kinds(self):
        """The kinds of the curves, in the order of the legend."""
        present = {row["kind"] for row in self._points}
        return [kind for kind in KINDS if kind in present]

    def line_lines(self, kind):
        """Both parameters along the curves of one kind, an empty line behind each curve."""
        before = None
        for row in self._points:
            if row["kind"] != kind:
                continue
            if before is not None and row["curve"] != before:
                yield ""
            before = row["curve"]
            yield self._at(row)
        yield ""

    def mark_lines(self):
        """Both parameters and the name of every meeting; one that lies on two curves once. Of meetings whose names would
        stand on each other the first one has all names, each once."""
        sizes = [max(values) - min(values) or 1 for values in
                 ([csv_table.number(row, name) for row in self._points] for name in COLUMNS)]
        named = []  # place, lines, names
        for row in self._meetings:
            place = [csv_table.number(row, name) / size for name, size in zip(COLUMNS, sizes)]
            near = next((one for one in named if all(abs(a - b) < w for a, b, w in zip(one[0], place, NAME_SIZE))), None)
            if near is None:
                named.append((place, [self._at(row)], [row["meeting"]]))
                continue
            if self._at(row) not in near[1]:
                near[1].append(self._at(row))
            if row["meeting"] not in near[2]:
                near[2].append(row["meeting"])
        for _, lines, names in named:
            yield f'{lines[0]} {",".join(names)}'
            yield from (f'{line} ""' for line in lines[1:])

    def logarithmic(self):
        """Which axes are drawn logarithmically, as the axes of the sweep that they are."""
        values = ([csv_table.number(row, name) for row in self._points] for name in COLUMNS)
        return map_axes.logarithmic(self.axes, *values)

    def cells(self, map_file):
        """The cells of a map in the plane of the curves."""
        plane = map_axes.read_plane(map_file)
        if (plane.across, plane.up) != self.parameters:
            raise csv_table.TableError(f"{plane.map_file}: is a map over {plane.across} and {plane.up}, "
                                       f"the curves are over {' and '.join(self.parameters)}")
        cells = domain_map.read_cells(plane.map_file, plane.up, None, plane.across)
        return domain_map.scaled(cells, {}, *(axis.factor for axis in self.axes))[0]

    def _at(self, row):
        return " ".join("%.17g" % (axis.factor * csv_table.number(row, name)) for axis, name in zip(self.axes, COLUMNS))


def options(parser):
    parser.add_argument("--map", metavar="DIR|MAP.csv", help="a map in the plane of the curves, whose cells stand behind them")


def picture(given):
    curves = Curves(given.source)
    cells = curves.cells(given.map) if given.map else []
    scales = curves.logarithmic()
    marks = list(curves.mark_lines())
    files = {kind: curves.line_lines(kind) for kind in curves.kinds()}
    return Picture(
        "curves.gp",
        (
            heading.text(given.heading, curves.config, varied=curves.parameters),
            " ".join(curves.kinds()),
            " ".join(sorted({cell.kind for cell in cells})),
            *(axis.label for axis in curves.axes),
            str(len(marks)),
            map_axes.scale_words(scales),
        ),
        files | {"meetings": marks, "cells": domain_map.cell_lines(cells, scales)},
        ("motion_kinds.gp",),
    )


SUBCOMMAND = Subcommand(
    name="curves",
    summary="curves of events in two parameters (rubbranch --curve)",
    description="""Draws what rubbranch --curve wrote into DIR: curves in the plane of both parameters by their kind, meetings
marked and named.""",
    source="DIR",
    heading="Where orbits end, in two parameters",
    picture=picture,
    units=("speed",),
    options=options,
    examples=("results/my_curve", "results/my_curve --map results/benchmark/one_side --output curves.pdf"),
)
