"""The tables that rubline wrote, for the pictures of them."""

import math
import os

from rubplot import configuration, csv_table, shown_units
from rubplot.motion_kinds import kind_of, may_be_drawn
from rubplot.failure import Failure, require_readable

PASSES = ("kick", "up", "down")


class Line:
    """A directory that rubline wrote: its cells in rows of line.csv, each with pass and kind of motion."""

    def __init__(self, directory):
        self.files = {name: os.path.join(directory, name)
                      for name in ("line.csv", "bifurcation.csv", "cascade.csv", "config.yaml")}
        require_readable(*self.files.values())
        self.config = configuration.read_configuration(self.files["config.yaml"])
        self.along = csv_table.head(self.files["line.csv"]).get("along")
        if not self.along:
            raise Failure(f"{self.files['line.csv']}: it does not say along what")
        needed = ("pass", "value", "class", "order", "peak_displacement_m")
        self.cells = list(csv_table.read_table(self.files["line.csv"], *needed))
        if not self.cells:
            raise Failure(f"{self.files['line.csv']}: no row")
        for row in self.cells:
            if row["pass"] not in PASSES:
                raise Failure(f"{self.files['line.csv']}: '{row['pass']}' is no pass")
        self._kinds = {(row["pass"], row["value"]): kind_of(row) for row in self.cells}
        for kind in self._kinds.values():
            if not may_be_drawn(kind):
                raise Failure(f"{self.files['line.csv']}: '{kind}' is no kind of motion")
        self.passes = [name for name in PASSES if any(row["pass"] == name for row in self.cells)]

    @property
    def axis(self):
        """How the number that is varied is shown."""
        return shown_units.axis(self.config, self.along)

    @property
    def label(self):
        return self.axis.label

    def value(self, row):
        """Value of a row of any of the tables, in the unit that is shown."""
        return self.axis.factor * number(row, "value")

    def place(self, row):
        """Place of the value of a row on its axis, which may be logarithmic."""
        return math.log10(self.value(row)) if self.is_logarithmic else self.value(row)

    @property
    def is_logarithmic(self):
        return self.axis.logarithmic and all(number(row, "value") > 0 for row in self.cells)

    @property
    def kinds(self):
        """The kinds of motion that a picture shows, a blank around each."""
        return " " + " ".join(sorted(set(self._kinds.values()))) + " "

    def kind(self, row):
        """Value of a row of any of the tables."""
        if (row["pass"], row["value"]) not in self._kinds:
            raise Failure(f"{self.files['line.csv']}: no row of pass {row['pass']} at {row['value']}")
        return self._kinds[row["pass"], row["value"]]

    def clearance(self):
        """In the unit of the picture, as a text; "nan" where it changes along the line."""
        if self.along == "stops.0.clearance_m":
            return "nan"
        return "%.17g" % (shown_units.millimetres()[0] * configuration.number(self.config["stops.0.clearance_m"]))

    def has_fixed_wall(self):
        """Whether the first stop is flat and its direction the same along the line."""
        return self.config.get("stops.0.kind") == "one_side" and self.along != "stops.0.angle_deg"

    def towards_wall(self):
        """Unit vector along which the section is drawn: towards a flat first stop, else up."""
        if not self.has_fixed_wall():
            return 0.0, 1.0
        angle = configuration.number(self.config["stops.0.angle_deg"]) * math.pi / 180
        return math.cos(angle), math.sin(angle)


def number(row, name):
    """The number in this column, where there has to be one."""
    value = csv_table.number(row, name)
    if value is None:
        raise Failure(f"column '{name}': an empty cell")
    return value
