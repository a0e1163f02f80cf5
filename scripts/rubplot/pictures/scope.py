"""A recording as rubscope sees it: orbit with the section, lines of the full spectrum, speed over time."""

import math
import os

from rubplot import csv_table, shown_units
from rubplot.failure import require_readable
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand


class Scope:
    """A directory that rubscope wrote. Lengths are drawn about the centre of the orbit."""

    def __init__(self, directory):
        files = {name: os.path.join(directory, f"{name}.csv") for name in ("orbit", "turns", "lines", "measures")}
        require_readable(*files.values())
        rows = {name: list(csv_table.read_table(path)) for name, path in files.items()}
        self.plane = bool(rows["orbit"]) and "y_m" in rows["orbit"][0]
        self._number = csv_table.number
        self.orbit = [self._place(row, "turns") for row in rows["orbit"]]
        self.centre = tuple(sum(point[i] for point in self.orbit) / len(self.orbit) for i in range(2))
        self.section = [(*self._place(row, "turn"), self._number(row, "t_s"), self._number(row, "speed_hz")) for row in rows["turns"]]
        self.lines = [tuple(self._number(row, name) for name in ("order", "amplitude_m", "uncertainty_m")) for row in rows["lines"]]
        self.measures = {row["quantity"]: row["value"] for row in rows["measures"]}
        largest = max(abs(value - self.centre[i]) for point in self.orbit for i, value in enumerate(point))
        self.per_metre, self.unit = shown_units.of_length(largest)

    def _place(self, row, along):
        """x and y of two probes; of one the turns of the shaft stand in for x."""
        x = self._number(row, "x_m")
        return (x, self._number(row, "y_m")) if self.plane else (self._number(row, along), x)

    def _shown(self, point):
        """In `unit` about the centre; of one probe the first number stays as it is."""
        first = self.per_metre * (point[0] - self.centre[0]) if self.plane else point[0]
        return f"{first:.17g} {self.per_metre * (point[1] - self.centre[1]):.17g}"

    def closed_orbit(self):
        """The mean period; of two probes with its first point again at the end."""
        yield from map(self._shown, self.orbit + (self.orbit[:1] if self.plane and "period_turns" in self.measures else []))

    def marks(self):
        """The section; of one probe, whose orbit is drawn over turns, at the turns of its period."""
        period = int(self.measures.get("period_turns", len(self.section)))
        for turn, point in enumerate(self.section):
            yield self._shown(point[:2] if self.plane else (turn % period, point[1]))

    def spectrum(self):
        """Order, amplitude and its standard uncertainty in `unit`, without 0X."""
        for order, amplitude, uncertainty in self.lines:
            if order:
                yield f"{order:.17g} {self.per_metre * amplitude:.17g} {self.per_metre * uncertainty:.17g}"

    def speed(self):
        for *_, t_s, speed_hz in self.section:
            yield f"{t_s:.17g} {speed_hz:.17g}"

    def label(self):
        period = self.measures.get("period_turns")
        return "no period" if period is None else f"period {period} turn" + "s" * (period != "1")

    def widest(self):
        """Half the side of the square that holds orbit and section."""
        points = self.orbit + [point[:2] for point in self.section]
        return 1.1 * self.per_metre * max(math.hypot(x - self.centre[0], y - self.centre[1]) for x, y in points)


def picture(given):
    scope = Scope(given.source)
    return Picture(
        "scope.gp",
        (given.heading, scope.label(), scope.unit, "1" if scope.plane else "0", "%.17g" % scope.widest() if scope.plane else "0"),
        {"orbit": scope.closed_orbit(), "section": scope.marks(), "spectrum": scope.spectrum(), "speed": scope.speed()},
    )


SUBCOMMAND = Subcommand(
    name="scope",
    summary="a recorded motion (rubscope)",
    description="""Draws what rubscope wrote into DIR: the mean period of the recorded motion with the position of the shaft
at each passage of the mark, the lines of its full spectrum over their noise, and the speed over time.""",
    source="DIR",
    heading="Recording",
    picture=picture,
    examples=("measured_scope", "measured_scope --heading 'Kit 2, Monday'"),
)
