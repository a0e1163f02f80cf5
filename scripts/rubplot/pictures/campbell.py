"""A Campbell diagram: curves by direction, critical speeds, the shaft and its mode shapes."""

import os
from itertools import groupby

from rubplot import captions, configuration, csv_table, shown_units
from rubplot.failure import require_readable
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

WHIRLS = ("forward", "backward", "mixed")
MOST_SHAPES = 4
SAME_SPEED = 0.015  # as a share: critical speeds with one label
# Distances as shares of the picture's width and height.
CLOSE = 0.09
BESIDE_AXIS = 0.1
SAME_HEIGHT = 0.03
ABOVE = 0.035  # names of 1X and 2X over their lines
# A letter of a label and the place of its line, as shares of the axes; further steps up or down for a label, in lines.
LETTER = (0.0125, 0.036)
STEPS = (0, 1.1, 2.2, 3.3)


def picture(given):
    directory = given.source
    names = ("campbell.csv", "critical_speeds.csv", "mode_shapes.csv", "config.yaml")
    files = {name: os.path.join(directory, name) for name in names}
    require_readable(*files.values())
    curves = _numbers(files["campbell.csv"], "mode", "speed_hz", "frequency_hz")
    critical = _numbers(files["critical_speeds.csv"], "mode", "speed_hz")
    locks = _lock_speeds(os.path.join(directory, "lock_speeds.csv"))
    shapes = _numbers(files["mode_shapes.csv"], "mode", "frequency_hz", "position_m", "x_real", "y_real", "x_imag", "y_imag")
    config = configuration.read_configuration(files["config.yaml"])
    per_hz = shown_units.axis(config, "speed_hz").factor
    fastest = max((row["speed_hz"] for row in curves), default=0)
    slowest = min((row["speed_hz"] for row in curves), default=0)
    # As high as shows where the modes meet the shaft speed, and the slowest mode in any case.
    top = max(1.5 * fastest, 1.3 * min((row["frequency_hz"] for row in curves), default=0))
    first = place_of_1x(critical, fastest, slowest, crossed(curves, top, lambda speed: speed + ABOVE * top))
    second = place_of_2x(fastest, top, slowest, crossed(curves, top, lambda speed: 2 * speed + ABOVE * top))
    sizes = [
        f"fastest = {fastest:.17g}",
        f"name_of_1x = {first:.17g}",
        f"above_line = {ABOVE * top:.17g}",
        f"name_of_2x = {second or 0:.17g}",
        f"top = {top:.17g}",
        f"per_hz = {per_hz:.17g}",  # of the unit in which shaft speeds are shown
        f"any_critical = {len(critical) > 0:d}",
        f"any_locks = {len(locks) > 0:d}",
        f"any_mixed = {any(row['whirl'] == 'mixed' for row in curves):d}",
    ]
    shown = shown_shapes(shapes)
    return Picture(
        "campbell.gp",
        (captions.headed(given.heading, config), str(len(shown)), captions.byline(config)),
        {
            "curves": curve_lines(curves, per_hz),
            # One beside the picture where there is none, as gnuplot warns of empty files.
            "critical": ["%.17g" % row["speed_hz"] for row in critical] or ["-1"],
            "labels.gp": [*sizes, *name_lines(curves, top, per_hz), *label_lines(critical, fastest, per_hz, slowest, top, curves),
                          *lock_lines(locks, top, per_hz)],
            "shapes": shape_lines(shown),
            "shaft": shaft_lines(config),
        },
    )


def curve_lines(rows, per_hz=1):
    """Speed, frequency and direction (0 forward, 1 backward, 2 mixed); a block for each stretch of one direction."""
    for _, mode in groupby(rows, key=lambda row: row["mode"]):
        last = None
        for row in mode:
            direction = WHIRLS.index(row["whirl"])
            point = "%.17g %.17g" % (per_hz * row["speed_hz"], row["frequency_hz"])
            if last is not None and last[1] != direction:
                # The stretches meet.
                yield f"{point} {last[1]}"
                yield ""
            yield f"{point} {direction}"
            last = (point, direction)
        yield ""


def name_lines(rows, top, per_hz=1):
    """The number of each mode at its end, as gnuplot's labels; modes that end at one place share one. None stands on the
    axis of speeds."""
    ends = [list(mode)[-1] for _, mode in groupby(rows, key=lambda row: row["mode"])]
    for speed in sorted({row["speed_hz"] for row in ends}):
        shown = sorted((row for row in ends if row["speed_hz"] == speed and row["frequency_hz"] < top), key=lambda row: row["frequency_hz"])
        for cluster in _clusters(shown, "frequency_hz", SAME_HEIGHT * top):
            place = max(sum(row["frequency_hz"] for row in cluster) / len(cluster), SAME_HEIGHT * top)
            text = ",".join("%d" % row["mode"] for row in cluster)
            yield _label(per_hz * speed, place, text, "left offset 0.6, 0")


def label_lines(rows, fastest, per_hz=1, slowest=0, top=None, curves=()):
    """Critical speeds as gnuplot's labels; speeds that lie together get one, from the first to the last. It stands above to the left
    of the line, below to the right where the next one is close, above to the right beside the axis; where another label
    has that place, or a curve goes through it, on the other side, or further above or below."""
    width, height = fastest - slowest or 1, top or 1.5 * fastest or 1
    clusters = list(_clusters(sorted(rows, key=lambda row: row["speed_hz"]), "speed_hz", 0, SAME_SPEED))
    middles = [sum(row["speed_hz"] for row in cluster) / len(cluster) for cluster in clusters]
    taken = []
    drawn = [((speed - slowest) / width, frequency / height) for speed, frequency in _points_between(curves)]
    for cluster, middle, following in zip(clusters, middles, [*middles[1:], float("inf")]):
        text = "–".join(dict.fromkeys("%.4g" % (per_hz * one["speed_hz"]) for one in (cluster[0], cluster[-1])))
        above, below = [("right", -0.8, 0.8 + step) for step in STEPS], [("left", 0.8, -0.8 - step) for step in STEPS]
        first, second = above, below
        if middle - slowest < BESIDE_AXIS * width:
            first = [("left", 0.3, 0.9 + step) for step in STEPS]
        elif following < middle + CLOSE * width:
            first, second = below, above
        places = [place for pair in zip(first, second) for place in pair]
        boxes = [_box((middle - slowest) / width, middle / height, text, place) for place in places]
        free = [i for i, box in enumerate(boxes) if _inside(box) and not any(_meet(box, other) for other in taken)]
        chosen = min(free, key=lambda i: sum(_holds(boxes[i], point) for point in drawn), default=0)
        taken.append(boxes[chosen])
        side, across, up = places[chosen]
        yield _label(per_hz * middle, middle, text, f"{side} offset {across:g}, {up:g} boxed")


def _box(x, y, text, place):
    """(left, low, right, high) of a label at a point, all as shares of the axes."""
    side, across, up = place
    left = x + across * LETTER[0] - (len(text) * LETTER[0] if side == "right" else 0)
    return left, y + (up - 0.5) * LETTER[1], left + len(text) * LETTER[0], y + (up + 0.5) * LETTER[1]


def _points_between(curves, parts=8):
    """Points of the curves, so close that none of them crosses a label between two."""
    for _, mode in groupby(curves, key=lambda row: row["mode"]):
        last = None
        for row in mode:
            point = (row["speed_hz"], row["frequency_hz"])
            for part in range(parts if last else 0):
                yield tuple(a + (b - a) * part / parts for a, b in zip(last, point))
            last = point


def _holds(box, point):
    return box[0] <= point[0] <= box[2] and box[1] <= point[1] <= box[3]


def _inside(box):
    return box[0] > 0 and box[1] > 0 and box[2] < 1 and box[3] < 1


def _meet(one, other):
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def lock_lines(speeds, top, per_hz=1):
    """A diamond on the axis of speeds for each lock speed, as gnuplot's labels."""
    for speed in speeds:
        yield _label(per_hz * speed, 0.012 * top, "", "point pointtype 12 pointsize 1.3 linewidth 1.5 linecolor rgb '#882255'")


def place_of_1x(critical, fastest, slowest=0, blocked=lambda place: False):
    """The speed at which the line of the shaft speed is named: near its end, but not where a critical speed is, and where
    it can be not where it is `blocked`."""
    width = fastest - slowest
    places = [slowest + share * width for share in (0.94, 0.85, 0.76, 0.67, 0.58, 0.49, 0.4, 0.31, 0.22)]

    def room(place):
        return min((abs(row["speed_hz"] - place) for row in critical), default=fastest)

    roomy = [place for place in places if room(place) > BESIDE_AXIS * width] or [max(places, key=room)]
    return next((place for place in roomy if not blocked(place)), roomy[0])


def place_of_2x(fastest, top, slowest=0, blocked=lambda place: False):
    """As well for twice the shaft speed: near its upper end, None where that is beside the axes or next to it."""
    width = fastest - slowest
    highest = min(0.47 * top, slowest + 0.9 * width)
    places = [highest - share * width for share in (0, 0.06, 0.12, 0.18, 0.24) if highest - share * width > slowest + BESIDE_AXIS * width]
    return next((place for place in places if not blocked(place)), places[0] if places else None)


def crossed(curves, top, up):
    """Whether a curve goes through a text at `up(speed)` that ends at this speed."""
    width = max((row["speed_hz"] for row in curves), default=0) - min((row["speed_hz"] for row in curves), default=0)

    def blocked(speed):
        return any(-0.06 * width <= row["speed_hz"] - speed <= 0.02 * width and abs(row["frequency_hz"] - up(speed)) < 0.022 * top
                   for row in curves)

    return blocked


def _label(x, y, text, place):
    return f"set label '{text}' at first {x:.17g}, first {y:.17g} {place} front font ',16'"


def _clusters(rows, name, distance, share=0.0):
    """Splits rows in ascending order of a column where one lies further from the one before than a distance, or a share
    of its value."""
    cluster = []
    for row in rows:
        if cluster and row[name] > cluster[-1][name] * (1 + share) + distance:
            yield cluster
            cluster = []
        cluster.append(row)
    if cluster:
        yield cluster


def shown_shapes(rows):
    """The first modes that whirl forward, or in no clear direction: a backward one bends the shaft as its partner does.
    None where there is no shaft to bend."""
    modes = [(number, list(points)) for number, points in groupby(rows, key=lambda row: row["mode"])]
    shown = [mode for mode in modes if mode[1][0]["whirl"] != "backward" and len(mode[1]) > 1]
    return shown[:MOST_SHAPES]


def shape_lines(shown):
    """A data set for each mode, its number and frequency as the title: position in mm, and the deflection in the plane in
    which it is larger, at the instant at which it is largest there."""
    for number, points in shown:
        across = max(abs(complex(row["x_real"], row["x_imag"])) for row in points)
        up = max(abs(complex(row["y_real"], row["y_imag"])) for row in points)
        name = "x_real" if across >= (1 - 1e-6) * up else "y_real"
        yield '"mode %d, %.4g Hz"' % (number, points[0]["frequency_hz"])
        for row in points:
            yield "%.17g %.17g" % (1e3 * row["position_m"], row[name])
        yield ""
        yield ""


def shaft_lines(config):
    """Place in mm and kind of what stands on the shaft: 0 disc, 1 support, 2 stop."""
    for kind, path in enumerate(("rotor.discs", "rotor.supports", "stops")):
        count = 0
        while f"{path}.{count}.position_m" in config:
            yield "%.17g %d" % (1e3 * configuration.number(config[f"{path}.{count}.position_m"]), kind)
            count += 1


def _lock_speeds(path):
    """Speeds at which two modes can lock, in Hz; none where the diagram was made before there were any."""
    if not os.path.exists(path):
        return []
    speeds = [csv_table.number(row, "speed_hz") for row in csv_table.read_table(path, "speed_hz")]
    if None in speeds:
        raise csv_table.TableError(f"{path}: a row without numbers")
    return speeds


def _numbers(path, *names):
    """The rows of a table, these columns as numbers and the column whirl as the word that it is."""
    rows = []
    for row in csv_table.read_table(path, "whirl", *names):
        if row["whirl"] not in WHIRLS:
            raise csv_table.TableError(f"{path}: '{row['whirl']}' is no direction of whirl")
        numbers = {name: csv_table.number(row, name) for name in names}
        if None in numbers.values():
            raise csv_table.TableError(f"{path}: a row without numbers")
        rows.append({"whirl": row["whirl"], **numbers})
    return rows


SUBCOMMAND = Subcommand(
    name="campbell",
    summary="Campbell diagram and mode shapes (rubtrace --campbell)",
    description="""Draws what rubtrace --campbell wrote into DIR: whirl frequencies over the shaft speed, critical speeds,
and of a rotor kit the mode shapes along the shaft.""",
    source="DIR",
    heading="Campbell diagram",
    picture=picture,
    units=("speed",),
    examples=("results/my_campbell", "results/my_campbell --output campbell.svg"),
)
