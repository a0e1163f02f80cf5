"""Where two maps differ: the verdict of rubsweep-compare on each cell."""

import os

from rubplot import configuration, csv_table, domain_map, heading, map_axes, shown_units
from rubplot.gnuplot import Picture
from rubplot.gnuplot_text import quoted
from rubplot.subcommand import Subcommand

# Verdict, name in the legend and colour; the worst last, on top where several cells lie in one place.
STYLES = (
    ("equal", "equal", "#D9D9D9"),
    ("sensitive", "sensitive, not compared", "#9ECAE1"),
    ("numbers_differ", "other numbers", "#FDAE61"),
    ("classes_differ", "another class", "#D7191C"),
    ("only_in_one", "in one map only", "#000000"),
)
VERDICT = "verdict"


class Comparison:
    """The table that rubsweep-compare --cells wrote, with the configuration beside its first map, if that is there."""

    def __init__(self, path):
        head = csv_table.head(path)
        self.maps = [head.get(name, "?") for name in ("a", "b")]
        self.tolerance = head.get("tolerance", "")
        self.rows = list(csv_table.read_table(path, VERDICT))
        known = {verdict for verdict, _, _ in STYLES}
        for row in self.rows:
            if row[VERDICT] not in known:
                raise csv_table.TableError(f"{path}: '{row[VERDICT]}' is no verdict")
        if not self.rows:
            raise csv_table.TableError(f"{path}: no cells")
        file = os.path.join(os.path.dirname(self.maps[0]), "config.yaml")
        self.config = configuration.read_configuration(file) if os.path.exists(file) else {}
        self.columns = self._columns()

    def _columns(self):
        """The first two numbers of a cell with several values; speed and unbalance where there are not so many."""
        names = list(self.rows[0])
        names = names[: names.index(VERDICT)]
        swept = [name for name in names if len({row[name] for row in self.rows}) > 1]
        return (swept + [name for name in names if name not in swept])[:2]

    def what(self):
        """Names of both maps, and how numbers were compared."""
        tolerance = f"; numbers to a tolerance of {self.tolerance}" if self.tolerance else ""
        return " → ".join(self.maps) + tolerance

    def places(self, column):
        """The numbers of all cells in a column."""
        return [csv_table.number(row, column) for row in self.rows]


def picture(given):
    comparison = Comparison(given.source)
    places = [comparison.places(column) for column in comparison.columns]
    axes = [shown_units.axis(comparison.config, column, max(values)) for column, values in zip(comparison.columns, places)]
    places = [[axis.factor * value for value in values] for axis, values in zip(axes, places)]
    scales = map_axes.logarithmic(axes, *places)
    edges = [domain_map.edges(values, scale) for values, scale in zip(places, scales)]
    cells = {}
    for x, y, row in zip(*places, comparison.rows):
        numbers = (x, y, *edges[0][x], *edges[1][y])
        cells.setdefault(row[VERDICT], []).append(" ".join("%.17g" % number for number in numbers))
    shown = [style for style in STYLES if style[0] in cells]
    legend = [f"array name[{len(shown)}]"]
    legend += [f"name[{k}] = {quoted(f'{name} ({len(cells[verdict])})')}" for k, (verdict, name, _) in enumerate(shown, 1)]
    differ = any(verdict not in ("equal", "sensitive") for verdict, _, _ in shown)
    title = given.heading or ("Where two maps differ" if differ else "Two maps that are equal")
    return Picture(
        "compare.gp",
        (
            f"{{/:Bold {heading.plain(title)}}}\n{{/*0.75 {heading.plain(comparison.what())}}}",
            " ".join(verdict for verdict, _, _ in shown),
            " ".join(colour for _, _, colour in shown),
            *(map_axes.label(axis) for axis in axes),
            map_axes.scale_words(scales),
        ),
        cells | {"legend.gp": legend},
    )


SUBCOMMAND = Subcommand(
    name="compare",
    summary="where two maps differ (rubsweep-compare --cells)",
    description="""Draws the table that rubsweep-compare A.csv B.csv --cells CELLS.csv wrote: the verdict on each cell, in the
units of the configuration beside the first map.""",
    source="CELLS.csv",
    picture=picture,
    units=("speed",),
    examples=("cells.csv --output difference.pdf",),
)
