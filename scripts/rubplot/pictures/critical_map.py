"""An undamped critical speed map: critical speeds over the stiffness of the bearings, with the bearings' own curves."""

import math
from itertools import groupby

from rubplot import captions, configuration, gnuplot_text, report_tables, shown_units
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

MOST_CURVES = 6
SAME = 1e-3  # as a share: curves of bearings that differ by less are one


def picture(given):
    directory = given.source
    modes = report_tables.numbers(report_tables.require(directory, "critical_map.csv", "critical_map"), "stiffness_n_per_m", "mode", "speed_hz")
    bearings = report_tables.numbers(report_tables.path_of(directory, "bearing_stiffness.csv"), "speed_hz", "stiffness_x_n_per_m",
                                     "stiffness_y_n_per_m")
    config = configuration.read_configuration(report_tables.path_of(directory, "config.yaml"))
    axis = shown_units.axis(config, "speed_hz")
    operating = report_tables.operating_hz(directory)
    curves = merged(bearing_curves(bearings))[:MOST_CURVES]
    by_mode = [[(row["stiffness_n_per_m"], row["speed_hz"]) for row in rows] for _, rows in groupby(
        sorted(modes, key=lambda row: row["mode"]), key=lambda row: row["mode"])]
    speeds = [speed for mode in by_mode for _, speed in mode] + list(operating or [])
    low, high = 10 ** math.floor(math.log10(min(speeds))), 10 ** math.ceil(math.log10(max(speeds)))
    # Speeds far below the operating range say nothing of it.
    low = max(low, 10 ** math.floor(math.log10(operating[0] / 100))) if operating else low
    return Picture(
        "critical_map.gp",
        (captions.headed(given.heading, config), captions.byline(config), axis.label, str(len(curves))),
        {
            **{f"curve_{i}": ("%.17g %.17g" % (k, axis.factor * speed) for speed, k in curve[1]) for i, curve in enumerate(curves)},
            "modes": mode_lines(by_mode, axis.factor),
            "labels.gp": [
                f"least_stiffness = {min(row['stiffness_n_per_m'] for row in modes):.17g}",
                f"most_stiffness = {max(row['stiffness_n_per_m'] for row in modes):.17g}",
                f"low = {axis.factor * low:.17g}",
                f"high = {axis.factor * high:.17g}",
                f"band_from = {axis.factor * operating[0] if operating else 0:.17g}",
                f"band_to = {axis.factor * operating[1] if operating else 0:.17g}",
                *(f"curve_name_{i} = {gnuplot_text.quoted(curve[0])}" for i, curve in enumerate(curves)),
                *name_lines(by_mode, axis.factor, low, high),
            ],
        },
    )


def bearing_curves(rows):
    """(name, [(speed, stiffness)]) of each bearing along x and y, one where both are the same."""
    found = []
    for name, of_one in groupby(rows, key=lambda row: row["bearing"]):
        of_one = list(of_one)
        x, y = ([(row["speed_hz"], row[f"stiffness_{plane}_n_per_m"]) for row in of_one] for plane in "xy")
        found += [(name, x)] if _same(x, y) else [(f"{name}, x", x), (f"{name}, y", y)]
    return found


def merged(curves):
    """Curves that are the same as one, with all their names."""
    found = []
    for name, curve in curves:
        other = next((one for one in found if _same(one[1], curve)), None)
        if other:
            other[0].append(name)
        else:
            found.append(([name], curve))
    return [("; ".join(names), curve) for names, curve in found]


def _same(one, other):
    return len(one) == len(other) and all(abs(a[1] - b[1]) <= SAME * abs(a[1]) for a, b in zip(one, other))


def mode_lines(by_mode, per_hz):
    """Stiffness and speed, a block for each mode."""
    for mode in by_mode:
        for stiffness, speed in mode:
            yield "%.17g %.17g" % (stiffness, per_hz * speed)
        yield ""


def name_lines(by_mode, per_hz, low, high):
    """The number of each mode beside the right end of its curve; those that end together share one."""
    span = math.log10(high / low)
    ends = []
    for number, mode in enumerate(by_mode, 1):
        speed = mode[-1][1]
        if ends and abs(math.log10(speed / ends[-1][0])) < 0.028 * span:
            ends[-1][1].append(number)
        elif low < speed < high:
            ends.append((speed, [number]))
    for speed, numbers in ends:
        text = ("mode " if len(numbers) == 1 else "modes ") + ", ".join(map(str, numbers))
        yield f"set label '{text}' at graph 1, first {per_hz * speed:.17g} left offset 0.5, 0 font ',17'"


SUBCOMMAND = Subcommand(
    name="critical-map",
    summary="undamped critical speeds over the stiffness of the bearings",
    description="""Draws the undamped critical speed map that rubtrace --rotor-report wrote into DIR: critical speeds of forward
whirl if all bearings had one stiffness, and where the stiffness of the bearings themselves crosses them.""",
    source="DIR",
    heading="Undamped critical speed map",
    picture=picture,
    units=("speed",),
    examples=("results/my_rotor", "results/my_rotor --output map.svg --speed-unit rpm"),
)
