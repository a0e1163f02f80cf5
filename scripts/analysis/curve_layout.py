"""Lays out what rubbranch --curve wrote for curve_figure.gp: a line for every curve, and marks at meetings."""

import os

import csv_table

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
        named = {}
        with open(path, encoding="utf-8") as file:
            for line in file:
                words = line.split()
                if len(words) == 3 and words[0] == "#":
                    named[words[1]] = words[2]
        self.parameters = (named.get("parameter", "parameter"), named.get("curve_parameter", "curve_parameter"))

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
            yield _at(row)
        yield ""

    def mark_lines(self):
        """Both parameters and the name of every meeting; one that lies on two curves once."""
        seen = set()
        for row in self._meetings:
            key = (row["meeting"], *(f"{csv_table.number(row, name):.6g}" for name in ("parameter", "curve_parameter")))
            if key not in seen:
                seen.add(key)
                yield f"{_at(row)} {row['meeting']}"


def _at(row):
    return f"{csv_table.number(row, 'parameter'):.17g} {csv_table.number(row, 'curve_parameter'):.17g}"
