"""What bifurcation.gp and cascade.gp need of what rubline wrote."""

import math
import os
import re

import configuration
import csv_table
import shown_units
from command import Failure, require_readable
from domain_map import kind_of
from domain_measures import spread

PASSES = ("kick", "up", "down")
_KIND = re.compile(r"[a-z_0-9]+")

# The cascade goes on to the last order with a line of this share of the largest.
LEAST_SHARE = 0.01
# More spectra than so many hide each other.
MOST_SPECTRA = 70
# Half the width of a peak, in orders.
PEAK = 0.02


class Line:
    """A directory that rubline wrote: its cells in rows of line.csv, each with pass and kind of motion."""

    def __init__(self, directory):
        self.files = {name: os.path.join(directory, name)
                      for name in ("line.csv", "bifurcation.csv", "cascade.csv", "config.yaml")}
        require_readable(*self.files.values())
        self.config = configuration.read_configuration(self.files["config.yaml"])
        self.along = _along(self.files["line.csv"])
        needed = ("pass", "value", "class", "order", "orbit", "whirl", "comb_spacing", "peak_displacement_m")
        self.cells = list(csv_table.read_table(self.files["line.csv"], *needed))
        if not self.cells:
            raise Failure(f"{self.files['line.csv']}: no row")
        for row in self.cells:
            if row["pass"] not in PASSES:
                raise Failure(f"{self.files['line.csv']}: '{row['pass']}' is no pass")
        self._kinds = {(row["pass"], row["value"]): kind_of(row) for row in self.cells}
        for kind in self._kinds.values():
            # It becomes part of gnuplot's commands.
            if not _KIND.fullmatch(kind):
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
        """Of a row of any of the tables, in the unit that is shown."""
        return self.axis.factor * _number(row, "value")

    @property
    def is_logarithmic(self):
        return self.axis.logarithmic and all(_number(row, "value") > 0 for row in self.cells)

    @property
    def kinds(self):
        """The kinds of motion that a picture shows, a blank around each."""
        return " " + " ".join(sorted(set(self._kinds.values()))) + " "

    def kind(self, row):
        """Of a row of any of the tables."""
        if (row["pass"], row["value"]) not in self._kinds:
            raise Failure(f"{self.files['line.csv']}: no row of pass {row['pass']} at {row['value']}")
        return self._kinds[row["pass"], row["value"]]

    def clearance_mm(self):
        """As a text; "nan" where it changes along the line."""
        if self.along == "stops.0.clearance_m":
            return "nan"
        return "%.17g" % (1e3 * configuration.number(self.config["stops.0.clearance_m"]))

    def has_fixed_wall(self):
        """Whether the first stop is flat and its direction the same along the line."""
        return self.config.get("stops.0.kind") == "one_side" and self.along != "stops.0.angle_deg"

    def towards_wall(self):
        """Unit vector along which the section is drawn: towards a flat first stop, else up."""
        if not self.has_fixed_wall():
            return 0.0, 1.0
        angle = configuration.number(self.config["stops.0.angle_deg"]) * math.pi / 180
        return math.cos(angle), math.sin(angle)


def section_lines(line):
    """Value, displacement towards the wall in mm, number of the pass, kind."""
    x, y = line.towards_wall()
    for row in csv_table.read_table(line.files["bifurcation.csv"], "pass", "value", "x_m", "y_m"):
        displacement = x * _number(row, "x_m") + y * _number(row, "y_m")
        yield f"{line.value(row):.17g} {1e3 * displacement:.17g} {PASSES.index(row['pass'])} {line.kind(row)}"


def peak_lines(line):
    """Value, largest displacement in mm, number of the pass; a block for each pass."""
    for name in line.passes:
        for row in line.cells:
            peak = csv_table.number(row, "peak_displacement_m")
            if row["pass"] == name and peak is not None:
                yield f"{line.value(row):.17g} {1e3 * peak:.17g} {PASSES.index(name)}"
        yield ""


class Spectrum:
    """One cell: its value, its kind, and its lines as (order, amplitude in mm) in rising order."""

    def __init__(self, value, kind):
        self.value, self.kind, self.lines = value, kind, []

    def outline(self, largest_order, height_per_mm):
        """The spectrum as one line on the height of its value, a narrow triangle for each of its lines."""
        points = [(-largest_order, 0.0)]
        for order, amplitude in self.lines:
            if abs(order) > largest_order - PEAK:
                continue
            if order - PEAK > points[-1][0] + PEAK:
                if points[-1][1] > 0:
                    points.append((points[-1][0] + PEAK, 0.0))
                points.append((order - PEAK, 0.0))
            points.append((order, amplitude))
        if points[-1][1] > 0:
            points.append((points[-1][0] + PEAK, 0.0))
        points.append((largest_order, 0.0))
        return [(order, self.value + height_per_mm * amplitude) for order, amplitude in points]


def spectra(line):
    """A dict from each pass to its spectra, the largest value first; of many, some that are evenly spread. 0X, which is no
    whirl, is left out."""
    by_cell = {(row["pass"], row["value"]): Spectrum(line.value(row), line.kind(row)) for row in line.cells}
    for row in csv_table.read_table(line.files["cascade.csv"], "pass", "value", "order", "amplitude_m"):
        line.kind(row)  # there is such a cell
        order = _number(row, "order")
        if order != 0:
            by_cell[row["pass"], row["value"]].lines.append((order, 1e3 * _number(row, "amplitude_m")))
    found = {}
    for name in line.passes:
        all_of_it = sorted((s for (of, _), s in by_cell.items() if of == name and s.lines), key=lambda s: -s.value)
        found[name] = spread(all_of_it, MOST_SPECTRA)
    return found


def largest_amplitude(all_spectra):
    """In mm; 0 where there is no line at all."""
    return max((amplitude for s in _each(all_spectra) for _, amplitude in s.lines), default=0.0)


def largest_order(all_spectra):
    """A whole number, at least 2: lines that show lie within."""
    least = LEAST_SHARE * largest_amplitude(all_spectra)
    return max(2, math.ceil(max((abs(order) for s in _each(all_spectra) for order, a in s.lines if a > least), default=0)))


def _each(all_spectra):
    return (spectrum for spectra_of_pass in all_spectra.values() for spectrum in spectra_of_pass)


def _along(path):
    """What changes along the line, which a comment says."""
    with open(path, encoding="utf-8", errors="replace") as file:
        for text in file:
            if text.startswith("# along "):
                return text[len("# along "):].strip()
            if not text.startswith("#"):
                break
    raise Failure(f"{path}: it does not say along what")


def _number(row, name):
    value = csv_table.number(row, name)
    if value is None:
        raise Failure(f"column '{name}': an empty cell")
    return value
