"""A cascade: full spectra along a line, one panel for each pass."""

import math

from rubplot import csv_table, heading
from rubplot.evenly_spread import spread
from rubplot.failure import Failure
from rubplot.gnuplot import Picture
from rubplot.line_tables import Line, number
from rubplot.subcommand import Subcommand

# The cascade goes on to the last order with a line of this share of the largest.
LEAST_SHARE = 0.01
# More spectra than so many hide each other.
MOST_SPECTRA = 70
# Half the width of a peak, in orders.
PEAK = 0.02
# Height of the largest line, as a share of the whole line of cells.
HEIGHT = 0.16


class Spectrum:
    """One cell: the place of its value on the axis, its kind, and its lines as (order, amplitude in mm) in rising order."""

    def __init__(self, place, kind):
        self.place, self.kind, self.lines = place, kind, []

    def outline(self, largest_order, height_per_mm):
        """The spectrum as one line at the height of its place, a narrow triangle for each of its lines."""
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
        return [(order, self.place + height_per_mm * amplitude) for order, amplitude in points]


def spectra(line):
    """A dict from each pass to its spectra, the largest value first; of many, some that are evenly spread. 0X, which is no
    whirl, is left out."""
    by_cell = {(row["pass"], row["value"]): Spectrum(line.place(row), line.kind(row)) for row in line.cells}
    for row in csv_table.read_table(line.files["cascade.csv"], "pass", "value", "order", "amplitude_m"):
        line.kind(row)  # there is such a cell
        order = number(row, "order")
        if order != 0:
            by_cell[row["pass"], row["value"]].lines.append((order, 1e3 * number(row, "amplitude_m")))
    found = {}
    for name in line.passes:
        all_of_it = sorted((s for (of, _), s in by_cell.items() if of == name and s.lines), key=lambda s: -s.place)
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


def value_ticks(least, largest):
    """Ticks of a logarithmic axis of values, as gnuplot's list of labels and logarithms: 1, 2 and 5 times powers of ten."""
    first, last = math.floor(math.log10(least)), math.ceil(math.log10(largest))
    ticks = [digit * 10.0**power for power in range(first, last + 1) for digit in (1, 2, 5)]
    return ", ".join('"%g" %.17g' % (tick, math.log10(tick)) for tick in ticks if least <= tick * (1 + 1e-9) and tick <= largest * (1 + 1e-9))


def picture(given):
    line = Line(given.source)
    found = spectra(line)
    highest = largest_amplitude(found)
    if highest == 0:
        raise Failure(f"{line.files['cascade.csv']}: no line of a spectrum")
    values = [line.place(cell) for cell in line.cells]
    span = max(values) - min(values) or 1.0
    order = largest_order(found)
    height = HEIGHT * span / highest
    files = {name: _outlines(of_pass, order + 0.3, height) for name, of_pass in found.items()}
    ticks = value_ticks(10 ** min(values), 10 ** max(values)) if line.is_logarithmic else ""
    files["kinds.gp"] = [f"kinds_{name} = \"{' '.join(s.kind for s in of_pass)}\"" for name, of_pass in found.items()]
    files["kinds.gp"].append(f"value_ticks = '{ticks}'")
    return Picture(
        "cascade.gp",
        (
            heading.text(given.heading, line.config, varied=(line.along,)),
            line.kinds,
            " ".join(line.passes),
            line.label,
            "%.17g %.17g" % (min(values), min(values) + span),
            "%d %.17g %.17g" % (order, highest, height),
        ),
        files,
        ("motion_kinds.gp",),
    )


def _outlines(of_pass, largest, height):
    """A block of points for each spectrum, two empty lines behind it."""
    for spectrum in of_pass:
        yield from ("%.17g %.17g" % point for point in spectrum.outline(largest, height))
        yield "\n"


SUBCOMMAND = Subcommand(
    name="cascade",
    summary="cascade of full spectra of what rubline wrote",
    description="""Draws what rubline wrote into DIR: full spectra along the line, one panel for each pass, backward orders on
the left.""",
    source="DIR",
    heading="Cascade of full spectra",
    picture=picture,
    units=("speed",),
    examples=("results/my_line", "results/my_line --output cascade.pdf"),
)
