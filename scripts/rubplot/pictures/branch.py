"""Orbits that rubbranch followed: pieces of one order and stability, and marks at events."""

import os

from rubplot import configuration, csv_table, heading, shown_units
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

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
        self.parameter = csv_table.head(os.path.join(directory, "branch.csv")).get("parameter", "parameter")
        self.config = configuration.read_configuration(os.path.join(directory, "config.yaml"))
        self.axis = shown_units.axis(self.config, self.parameter)

    def orders(self):
        """The orders of the branches, ascending."""
        return sorted({int(csv_table.number(row, "order")) for row in self._points})

    def line_lines(self, order, stable):
        """Parameter and amplitude of the pieces that are so, an empty line behind each. A piece reaches to the first
        orbit beyond it, so that no gap is left."""
        before, drawing = None, False
        for row in self._points:
            if before is not None and row["branch"] != before["branch"]:
                if drawing:
                    yield ""
                before, drawing = None, False
            wanted = int(csv_table.number(row, "order")) == order and (row["stable"] == "1") == stable
            if wanted and not drawing and before is not None:
                yield self._at(before)
            if wanted or drawing:
                yield self._at(row)
            if drawing and not wanted:
                yield ""
            before, drawing = row, wanted
        if drawing:
            yield ""

    def mark_lines(self, kind):
        """Parameter and amplitude of the events of one kind."""
        return [self._at(row) for row in self._events if row["kind"] == kind]

    def is_logarithmic(self):
        """Whether the parameter is drawn logarithmically, as the axis of the sweep that it is."""
        return self.axis.logarithmic and all(csv_table.number(row, "parameter") > 0 for row in self._points)

    def _at(self, row):
        parameter = self.axis.factor * csv_table.number(row, "parameter")
        return f"{parameter:.17g} {shown_units.millimetres()[0] * csv_table.number(row, 'amplitude_m'):.17g}"


def picture(given):
    branches = Branches(given.source)
    marks = [kind for kind in MARKS if branches.mark_lines(kind)]
    files = {kind: branches.mark_lines(kind) for kind in marks}
    pieces = {f"{word}_{order}": list(branches.line_lines(order, word == "stable"))
              for word in ("stable", "unstable") for order in branches.orders()}
    pieces = {name: lines for name, lines in pieces.items() if lines}
    return Picture(
        "branch.gp",
        (
            heading.text(given.heading, branches.config, varied=(branches.parameter,)),
            " ".join(str(order) for order in branches.orders()),
            " ".join(pieces),
            " ".join(marks),
            branches.axis.label,
            "logx" if branches.is_logarithmic() else "",
            shown_units.millimetres()[1],
        ),
        files | pieces,
    )


SUBCOMMAND = Subcommand(
    name="branch",
    summary="orbits that rubbranch followed, with their events",
    description="""Draws what rubbranch wrote into DIR: amplitude over the parameter, stable orbits in full lines and unstable
ones dashed, events marked.""",
    source="DIR",
    heading="Orbits along a parameter",
    picture=picture,
    units=("speed", "length"),
    examples=("results/benchmark/one_side_branch", "results/my_branch --output branch.pdf --heading 'The 1/2 orbit'"),
)
