"""Lays out what rubbranch wrote for branch_figure.gp: pieces of one order and stability, and marks at events."""

import os

import csv_table

# Events that are marked, in the order of the legend; each graze would hide the others.
MARKS = ("fold", "period_doubling", "period_halving", "neimark_sacker", "branch_point", "graze")


class Branches:
    """The tables of one directory."""

    def __init__(self, directory):
        self._points = list(
            csv_table.read_table(
                os.path.join(directory, "branch.csv"), "branch", "parameter", "order", "stable", "amplitude_m"
            )
        )
        if not self._points:
            raise csv_table.TableError(f"{directory}/branch.csv: no orbits")
        self._events = list(
            csv_table.read_table(os.path.join(directory, "events.csv"), "branch", "kind", "parameter", "amplitude_m")
        )
        with open(os.path.join(directory, "branch.csv"), encoding="utf-8") as file:
            named = [line.split()[2] for line in file if line.startswith("# parameter ")]
        self.parameter = named[0] if named else "parameter"

    def orders(self):
        """The orders of the branches, ascending."""
        return sorted({int(csv_table.number(row, "order")) for row in self._points})

    def line_lines(self, order, stable):
        """Parameter and amplitude in mm of the pieces that are so, an empty line behind each. A piece reaches to the first
        orbit beyond it, so that no gap is left."""
        before, drawing = None, False
        for row in self._points:
            if before is not None and row["branch"] != before["branch"]:
                if drawing:
                    yield ""
                before, drawing = None, False
            wanted = int(csv_table.number(row, "order")) == order and (row["stable"] == "1") == stable
            if wanted and not drawing and before is not None:
                yield _at(before)
            if wanted or drawing:
                yield _at(row)
            if drawing and not wanted:
                yield ""
            before, drawing = row, wanted
        if drawing:
            yield ""

    def mark_lines(self, kind):
        """Parameter and amplitude in mm of the events of one kind."""
        return [_at(row) for row in self._events if row["kind"] == kind]


def _at(row):
    return f"{csv_table.number(row, 'parameter'):.17g} {1e3 * csv_table.number(row, 'amplitude_m'):.17g}"
