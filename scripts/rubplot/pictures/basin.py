"""The slice of starts that rubbasin made, one colour for each attractor."""

import math
import os
import re

from rubplot import configuration, csv_table, domain_map, heading
from rubplot.failure import Failure, require_readable
from rubplot.gnuplot import Picture
from rubplot.motion_kinds import class_and_order, may_be_drawn
from rubplot.subcommand import Subcommand

# A legend has no room for more; the others share its last entry.
MOST_NAMED = 10
_STATE = re.compile(r"(?:casing([0-9]+)_)?(v?[xy])_m(_per_s)?")


class Attractor:
    """One row of attractors.csv; `legend` is what the picture says of it, behind the name of its kind unless it is a
    subharmonic."""

    def __init__(self, row, rank):
        self.kind = kind_of(row["label"])
        self.rank = rank  # of those of its kind, from 0
        self.legend = f": {100 * csv_table.number(row, 'share'):.1f} %"
        # Others have no length of their own.
        if self.kind in ("synchronous", "resting_contact") or self.kind.startswith("subharmonic"):
            self.legend = f", {1e3 * csv_table.number(row, 'peak_displacement_m'):.3g} mm" + self.legend
        # The name of the kind leaves orders from 8 on open.
        if self.kind.startswith("subharmonic"):
            self.legend = f"subharmonic 1/{_order(row['label'])}" + self.legend


class Slice:
    """A directory that rubbasin wrote."""

    def __init__(self, directory):
        files = {name: os.path.join(directory, name) for name in ("slice.csv", "attractors.csv", "config.yaml")}
        require_readable(*files.values())
        self.config = configuration.read_configuration(files["config.yaml"])
        self.columns = _columns(files["slice.csv"])
        self.starts = list(csv_table.read_table(files["slice.csv"], "attractor"))
        self.attractors = []
        for row in csv_table.read_table(files["attractors.csv"], "attractor", "label", "share", "peak_displacement_m"):
            kind = kind_of(row["label"])
            if not may_be_drawn(kind):
                raise Failure(f"{files['attractors.csv']}: '{kind}' is no kind of motion")
            rank = sum(known.kind == kind for known in self.attractors)
            self.attractors.append(Attractor(row, rank))
        if not self.starts:
            raise Failure(f"{files['slice.csv']}: no row")

    def numbers(self):
        """The attractor of each start: 0 where its run failed, MOST_NAMED + 1 for all that have no name of their own."""
        return [min(int(csv_table.number(row, "attractor") or 0), MOST_NAMED + 1) for row in self.starts]

    def wall(self):
        """(column, place): where the first wall is at rest, if it crosses the plane at right angles to an axis."""
        if self.config.get("stops.0.kind") != "one_side":
            return None
        angle = configuration.number(self.config["stops.0.angle_deg"]) % 360
        clearance = 1e3 * configuration.number(self.config["stops.0.clearance_m"])
        along = {0: ("x_m", clearance), 90: ("y_m", clearance), 180: ("x_m", -clearance), 270: ("y_m", -clearance)}
        column, place = along.get(angle, (None, 0))
        return (self.columns.index(column), place) if column in self.columns else None


def kind_of(label):
    """subharmonic 1/2 -> subharmonic_2."""
    name, slash, _ = label.partition(" 1/")
    return class_and_order(name, _order(label)) if slash else name


def axis_label(column):
    """Label of the axis of this column of slice.csv, in gnuplot's notation."""
    match = _STATE.fullmatch(column)
    if not match:
        return column.replace("_", r"\_")
    casing, name, velocity = match.groups()
    body = "rotor" if casing is None else f"casing of stop {casing}"
    place = ("velocity" if velocity else "displacement") + f" {name[-1]} of the {body}"
    return f"{place} ({'m/s' if velocity else 'mm'})"


def box_lines(slice_):
    """One line per start: x y left right bottom top attractor; lengths in mm."""
    places = [[_scaled(row, column) for row in slice_.starts] for column in slice_.columns]
    across, up = domain_map.edges(places[0]), domain_map.edges(places[1])
    for x, y, number in zip(*places, slice_.numbers()):
        yield " ".join("%.17g" % value for value in (x, y, *across[x], *up[y])) + f" {number}"


def _order(label):
    order = label.partition(" 1/")[2]
    if not order.isdecimal():
        raise Failure(f"'{label}' is no motion")
    return int(order)


def _scaled(row, column):
    value = csv_table.number(row, column)
    if value is None or not math.isfinite(value):
        raise Failure(f"column '{column}': '{row[column]}' is no place")
    match = _STATE.fullmatch(column)
    return 1e3 * value if match and not match[3] else value


def _columns(path):
    """The two numbers of a start, which stand before the column `attractor`."""
    for row in csv_table.read_table(path, "attractor"):
        names = list(row)
        if names.index("attractor") != 2:
            break
        return names[:2]
    raise Failure(f"{path}: not two numbers of a start before the column 'attractor'")


def picture(given):
    slice_ = Slice(given.source)
    named = slice_.attractors[:MOST_NAMED]
    wall = slice_.wall()
    return Picture(
        "basin.gp",
        (
            heading.text(given.heading, slice_.config, varied=slice_.columns),
            " ".join(f"{attractor.kind} {attractor.rank}" for attractor in named),
            "".join(attractor.legend + "|" for attractor in named),
            "%d" % max(0, len(slice_.attractors) - len(named)),
            axis_label(slice_.columns[0]),
            axis_label(slice_.columns[1]),
            "" if wall is None else "%d %.17g" % wall,
        ),
        {"starts": box_lines(slice_)},
        ("motion_kinds.gp",),
    )


SUBCOMMAND = Subcommand(
    name="basin",
    summary="slice of starts that rubbasin made, by the attractor that each leads to",
    description="Draws what rubbasin wrote into DIR: every start in the colour of the attractor that it leads to.",
    source="DIR",
    heading="Basins of attraction",
    picture=picture,
    examples=("results/my_basin", "results/my_basin --output basin.pdf --heading 'Two motions at 75 Hz'"),
)
