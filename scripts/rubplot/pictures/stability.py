"""Stability of a rotor: logarithmic decrement of its modes over the speed, and of the first forward one over cross-coupling."""

import math
import os

from rubplot import captions, configuration, csv_table, report_tables, shown_units
from rubplot.gnuplot import Picture
from rubplot.pictures import campbell
from rubplot.subcommand import Subcommand

TOP = 2.0  # modes above this decrement are far from any trouble
LIMIT = 0.1  # that API 617 asks of the first forward mode
SAME_HEIGHT = 0.035


def picture(given):
    directory = given.source
    path = os.path.join(directory, "campbell.csv")
    modes = decrements(csv_table.read_table(path, "mode", "whirl", "speed_hz", "damping_ratio"))
    config = configuration.read_configuration(report_tables.path_of(directory, "config.yaml"))
    coupling_path = os.path.join(directory, "stability.csv")
    coupling = report_tables.numbers(coupling_path, "coupling_n_per_m", "decrement") if os.path.exists(coupling_path) else []
    axis = shown_units.axis(config, "speed_hz")
    low, high = limits([row["decrement"] for row in modes])
    scale, unit = unit_of(max((row["coupling_n_per_m"] for row in coupling), default=0))
    zero = crossing(coupling)
    return Picture(
        "stability.gp",
        (captions.headed(given.heading, config), captions.byline(config), axis.label,
         "cross-coupled stiffness" + f" ({unit})", report_tables.note_text(directory, "stability")),
        {
            "modes": mode_lines(modes, axis.factor),
            "coupling": ["%.17g %.17g" % (scale * row["coupling_n_per_m"], row["decrement"]) for row in coupling] or ["0 0"],
            "labels.gp": [
                f"any_coupling = {len(coupling) > 0:d}",
                f"any_mixed = {any(row['whirl'] == 'mixed' for row in modes):d}",
                f"slowest = {axis.factor * min((row['speed_hz'] for row in modes), default=0):.17g}",
                f"fastest = {axis.factor * max((row['speed_hz'] for row in modes), default=1):.17g}",
                f"low = {low:.17g}",
                f"high = {high:.17g}",
                f"zero = {scale * zero if zero is not None else -1:.17g}",
                *name_lines(modes, low, high),
            ],
        },
    )


def decrements(rows):
    """The rows with their logarithmic decrement; without overdamped ones, which have none."""
    found = []
    for row in rows:
        ratio, speed = (csv_table.number(row, name) for name in ("damping_ratio", "speed_hz"))
        if row["whirl"] not in campbell.WHIRLS or ratio is None or speed is None:
            raise csv_table.TableError("campbell.csv: a row that no program writes")
        if abs(ratio) < 1:
            found.append({"mode": row["mode"], "whirl": row["whirl"], "speed_hz": speed,
                          "decrement": 2 * math.pi * ratio / math.sqrt(1 - ratio * ratio)})
    return found


def limits(values):
    """The range of the axis: with 0 and the limit, up to TOP at most."""
    shown = [value for value in values if value < TOP] or [0.0]
    least, most = min(0.0, *shown), max(2 * LIMIT, *shown)
    room = 0.06 * (most - least)
    return least - room, most + room


def unit_of(largest):
    """The scale and name of a unit of stiffness for values up to this one."""
    return next(((scale, name) for size, scale, name in ((1e9, 1e-9, "GN/m"), (1e6, 1e-6, "MN/m"), (1e3, 1e-3, "kN/m"))
                 if largest >= size), (1.0, "N/m"))


def crossing(rows):
    """The coupling at which the decrement is 0, None where it is not among the rows."""
    for one, other in zip(rows, rows[1:]):
        a, b = one["decrement"], other["decrement"]
        if a > 0 >= b:
            return one["coupling_n_per_m"] + (other["coupling_n_per_m"] - one["coupling_n_per_m"]) * a / (a - b)
    return None


def mode_lines(rows, per_hz):
    """Speed, decrement and direction (0 forward, 1 backward, 2 mixed); a block for each stretch of a mode in one direction."""
    last = None
    for row in rows:
        direction = campbell.WHIRLS.index(row["whirl"])
        if last is not None and (last["mode"] != row["mode"] or last["whirl"] != row["whirl"]):
            yield ""
            if last["mode"] == row["mode"]:  # the stretches meet
                yield "%.17g %.17g %d" % (per_hz * last["speed_hz"], last["decrement"], direction)
        yield "%.17g %.17g %d" % (per_hz * row["speed_hz"], row["decrement"], direction)
        last = row


def name_lines(rows, low, high):
    """The number of each mode at its end, as gnuplot's labels; those that end at one height share one."""
    last = {row["mode"]: row for row in rows}
    fastest = max((row["speed_hz"] for row in rows), default=0)
    shown = sorted((row["decrement"], mode) for mode, row in last.items() if low < row["decrement"] < high and row["speed_hz"] == fastest)
    clusters = []
    for height, mode in shown:
        if clusters and height - clusters[-1][0] < SAME_HEIGHT * (high - low):
            clusters[-1][1].append(mode)
        else:
            clusters.append((height, [mode]))
    for height, numbers in clusters:
        yield f"set label '{','.join(numbers)}' at graph 1, first {height:.17g} left offset 0.5, 0 font ',16'"


SUBCOMMAND = Subcommand(
    name="stability",
    summary="logarithmic decrements over speed and over cross-coupling",
    description="""Draws the stability of a rotor from what rubtrace --rotor-report wrote into DIR: logarithmic decrements of the
modes over the speed, and that of the first forward one over cross-coupled stiffness between the bearings. A mode below 0
grows.""",
    source="DIR",
    heading="Stability",
    picture=picture,
    units=("speed",),
    examples=("results/my_rotor", "results/my_rotor --output stability.pdf"),
)
