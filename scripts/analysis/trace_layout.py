"""What trace.gp needs of one trace: its title and its stops as assignments, its curves as files of columns."""

import math
import os
import re
from dataclasses import dataclass

import configuration
import csv_table
import shown_units
import spectrum_labels
from command import Failure, require_readable

# The spectrum is drawn to the eighth order; of an oval, which fills a ring as it turns, eight revolutions show how it
# begins.
LARGEST_ORDER = 8
REVOLUTIONS_OF_AN_OVAL = 8
LEAST_ORDER = 2
LEAST_SHARE = 0.01  # of the largest line: the spectra go on to the last order with so large a one
# The unit of lengths by the size of the motion in metres, so that the numbers at an axis stay short.
UNITS = ((2e-8, 1e9, "nm"), (2e-5, 1e6, "µm"), (math.inf, 1e3, "mm"))
SAME_PLACE = 1e-9

_NUMBER = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?")
_WHOLE = re.compile(r"0|[1-9][0-9]*")
_WORD = re.compile(r"[a-z_]+")


def checked(place, text, pattern):
    """`text`, if it is what the pattern says: what stands in a file becomes part of gnuplot's commands."""
    if not pattern.fullmatch(text):
        raise Failure(f"{place}: '{text}' is not allowed there")
    return text


@dataclass(frozen=True)
class Motion:
    """The row of motion.csv, as far as it is drawn. Texts, empty where the cell is."""

    speed: str
    whirl_ratio: str
    name: str
    order: str
    orbit: str
    whirl: str
    comb_spacing: str
    starts_at_rest: bool

    @property
    def speed_hz(self):
        return float(self.speed)


def read_motion(path):
    row = next(csv_table.read_table(path, "speed_hz", "whirl_ratio", "class", "order", "orbit", "whirl", "comb_spacing"), None)
    if row is None:
        raise Failure(f"{path}: no row")

    def cell(name, pattern, empty=True):
        return row[name] if empty and not row[name] else checked(path, row[name], pattern)

    return Motion(
        speed=cell("speed_hz", _NUMBER, empty=False),
        whirl_ratio=cell("whirl_ratio", _NUMBER),
        name=cell("class", _WORD, empty=False),
        order=cell("order", _WHOLE),
        orbit=cell("orbit", _WORD),
        whirl=cell("whirl", _WORD),
        comb_spacing=cell("comb_spacing", _NUMBER),
        # Where the quiet whirl itself reaches the wall, the rotor starts at rest and is not kicked.
        starts_at_rest=row.get("start") == "contact",
    )


def title(motion, speed, natural_frequency_hz=None, places=""):
    """Title of a row of panels; a rotor kit has many natural frequencies, and none in its configuration."""
    named = {"non_contact": "no contact", "resting_contact": "at rest on a stop"}
    name = named.get(motion.name, motion.name.replace("_", " "))
    if motion.order not in ("", "1"):
        name += f" 1/{motion.order}"
    if motion.name == "synchronous" and motion.orbit == "circle":
        name += " circle"
    if motion.comb_spacing:
        # A whip rolls backward along the wall. The oval turns in space while it is run through, and closes in the
        # rotating frame alone.
        kind = "quasi-periodic oval, closed in the rotating frame"
        if motion.whirl == "backward":
            kind = "backward dry whip"
        name = f"{kind}, lines at 1 ± k {'%.4g' % float(motion.comb_spacing)}"
    ratio = ""
    if natural_frequency_hz is not None:
        ratio = " = %.3g × natural frequency" % (motion.speed_hz / natural_frequency_hz)
    unbalance = "no clearance left at rest"
    if motion.whirl_ratio:
        unbalance = "whirl ratio %.3g" % float(motion.whirl_ratio)
    return f"{name}: {speed}{ratio}, {unbalance}" + (f"; {places}" if places else "")


@dataclass
class Stops:
    """The stops of a configuration in metres, and the columns of trajectory.csv that hold the moving walls. Only what
    stands where the rotor is looked at can be drawn around its orbit; what stands elsewhere along a shaft is drawn in the
    time history, together with the rotor there."""

    walls: list  # (normal x, normal y, clearance) of flat walls around the orbit
    rings: list  # (centre x, centre y, clearance), likewise
    moving: list  # (name of the column, y at rest) of walls that move up and down
    levels: list  # y of walls at rest that a time history reaches
    elsewhere: list  # (name of the gap's column, that of the casing or None, y at rest) of walls at other places
    places: str  # where the rotor is looked at and where stops stand elsewhere, in words; empty where they are one place


def observed_place_m(config):
    """Along the shaft of a rotor kit, where its first sensor is, else its first stop; None where there is no shaft."""
    for path in ("rotor.sensors.0.position_m", "stops.0.position_m"):
        if path in config:
            return configuration.number(config[path])
    return None


def read_stops(config):
    stops = Stops([], [], [], [], [], "")
    observed = observed_place_m(config)
    others = []
    for i in range(configuration.stop_count(config)):
        path = f"stops.{i}."
        place = configuration.number(config[path + "position_m"]) if path + "position_m" in config else observed
        here = place is None or abs(place - observed) < SAME_PLACE
        if not here:
            others.append(f"stop {i} at {1e3 * place:.4g} mm")
        _add_stop(stops, config, i, here)
    if others:
        stops.places = f"seen at {1e3 * observed:.4g} mm, {', '.join(others)}"
    return stops


def _add_stop(stops, config, i, here):
    path = f"stops.{i}."
    clearance_m = configuration.number(config[path + "clearance_m"])
    if config[path + "kind"] == "annular":
        # The casing's centre as seen from the rotor's rest position.
        offset = configuration.numbers(config.get(path + "offset_m", "[0, 0]"))
        if here:
            stops.rings.append((-offset[0], -offset[1], clearance_m))
            stops.levels += [-offset[1] - clearance_m, -offset[1] + clearance_m]
        return
    angle_deg = configuration.number(config[path + "angle_deg"])
    angle = angle_deg * math.pi / 180
    if here:
        stops.walls.append((math.cos(angle), math.sin(angle), clearance_m))
    upright = abs(math.remainder(angle_deg, 360)) == 90
    if not upright:
        return
    rest_m = math.copysign(clearance_m, math.sin(angle))
    casing = f"casing_{i}_y_m" if path + "casing.mass_kg" in config else None
    stops.levels.append(rest_m)
    if casing:
        stops.moving.append((casing, rest_m))
    if not here:
        stops.elsewhere.append((f"gap_{i}_m", casing, rest_m))


@dataclass(frozen=True)
class Spans:
    """Revolutions that are shown: history from `begin` to `end`, orbit and section up to the end of the run."""

    begin: int
    end: int
    orbit_from: int
    section_from: int


def spans(motion, first, last, window, revolutions):
    """Of a run of `last` revolutions whose trajectory begins with revolution `first`: the history shows so many
    `revolutions` of its beginning, or of its end where the number is negative."""
    begin, end = first, min(first + revolutions, last)
    if revolutions < 0:
        begin, end = max(last + revolutions, first), last
    # A periodic orbit closes after `order` revolutions; anything without order shows all that the spectrum was taken of.
    shown = window
    if motion.comb_spacing:
        shown = REVOLUTIONS_OF_AN_OVAL
    elif motion.order:
        shown = 2 * int(motion.order)
    return Spans(begin, end, max(last - shown, 0), last - window + 1 if last > window else 0)


def lay_out(directory, work, row_number, revolutions):
    """Writes the files work/ROW_NUMBER.* and returns the assignments of this row as a dict from the array's name."""
    files = {name: os.path.join(directory, name) for name in
             ("trajectory.csv", "section.csv", "spectrum.csv", "motion.csv", "config.yaml")}
    require_readable(*files.values())
    config = configuration.read_configuration(files["config.yaml"])
    motion = read_motion(files["motion.csv"])
    window = int(checked(files["config.yaml"], config["response.window_revolutions"], _WHOLE))
    gravity = checked(files["config.yaml"], config["gravity_m_per_s2"], _NUMBER)
    kick_s = checked(files["config.yaml"], config.get("kick.duration_s", "0"), _NUMBER)
    natural_hz = config.get("rotor.natural_frequency_hz")
    stops = read_stops(config)

    sections = list(csv_table.read_table(files["section.csv"], "revolution", "x_m", "y_m", "vy_m_per_s"))
    if not sections:
        raise Failure(f"{files['section.csv']}: no row")
    for name in ("y_m", "vy_m_per_s"):
        checked(files["section.csv"], sections[0][name], _NUMBER)
    last = int(checked(files["section.csv"], sections[-1]["revolution"], _WHOLE))
    seen = history_columns(stops)
    trajectory = list(csv_table.read_table(files["trajectory.csv"], "t_s", "x_m", "y_m", *seen))
    first = round(csv_table.number(trajectory[0], "t_s") * motion.speed_hz) if trajectory else 0
    shown = spans(motion, first, last, window, revolutions)

    # A sample at the begin of a revolution may lie a rounding before it.
    def instant(revolution):
        return (revolution - 1e-6) / motion.speed_hz

    history = csv_table.between(trajectory, "t_s", instant(shown.begin), shown.end / motion.speed_hz)
    orbit = list(csv_table.between(trajectory, "t_s", instant(shown.orbit_from)))
    section = csv_table.between(sections, "revolution", shown.section_from)
    spectrum = list(csv_table.between(
        csv_table.read_table(files["spectrum.csv"], "order", "amplitude_m"), "order", -LARGEST_ORDER, LARGEST_ORDER))
    base = os.path.join(work, str(row_number))
    _write(base + ".history", history, "t_s", "x_m", "y_m", *seen)
    _write(base + ".orbit", orbit, "x_m", "y_m")
    _write(base + ".section", section, "x_m", "y_m")
    _write(base + ".spectrum", spectrum, "order", "amplitude_m")

    probed = lay_out_probes(directory, work, row_number, shown, motion.speed_hz, config)
    size_m = max((abs(csv_table.number(row, name)) for row in orbit for name in ("x_m", "y_m")), default=1.0)
    per_metre, unit = next((factor, word) for largest_m, factor, word in UNITS if size_m < largest_m)

    def lengths(rows, columns=()):
        """All numbers but those at the places `columns`, which are no lengths, in the unit of the picture."""
        return _quoted("".join("%.17g " % (figure if k in columns else per_metre * figure)
                               for row in rows for k, figure in enumerate(row)))

    return {
        "row_title": _quoted(title(motion, shown_units.speed_text(config, motion.speed_hz), natural_hz and configuration.number(natural_hz), stops.places)),
        "probed": int(probed),
        "from": shown.begin,
        "to": shown.end,
        "speed_hz": motion.speed,
        "order": motion.order or 0,
        "kick_s": "0" if motion.starts_at_rest else kick_s,
        "at_rest": int(motion.starts_at_rest),
        "moving_walls": lengths(((_column(seen, name), rest_m) for name, rest_m in stops.moving), {0}),
        "elsewhere": lengths(
            ((_column(seen, gap), _column(seen, casing) if casing else 0, rest_m) for gap, casing, rest_m in stops.elsewhere),
            {0, 1}),
        "levels": lengths((level_m,) for level_m in stops.levels),
        "gravity": gravity,
        "start_y_m": sections[0]["y_m"],
        "start_vy_m_per_s": sections[0]["vy_m_per_s"],
        "walls": lengths(stops.walls, {0, 1}),
        "rings": lengths(stops.rings),
        "per_metre": "%g" % per_metre,
        "unit": _quoted(unit),
        "comb_spacing": motion.comb_spacing or 0,
        "highest": highest_order(spectrum),
    }


def history_columns(stops):
    """The columns of trajectory.csv that a time history needs beside time, x and y."""
    return [name for name, _ in stops.moving] + [gap for gap, _, _ in stops.elsewhere]


def _column(seen, name):
    """The place of a column in the file of a time history, from 1."""
    return 4 + seen.index(name)


def highest_order(spectrum):
    """The order to which a spectrum is drawn: lines that show lie within."""
    lines = [(csv_table.number(row, "order"), csv_table.number(row, "amplitude_m")) for row in spectrum]
    least = LEAST_SHARE * max((amplitude for _, amplitude in lines), default=0)
    return max([LEAST_ORDER, *(math.ceil(abs(order)) for order, amplitude in lines if amplitude > least)])


def lay_out_labels(work, row_number, row, highest):
    """Writes work/ROW_NUMBER.labels: the lines to name in a picture that goes to the order `highest`; `row` is what
    lay_out returned."""
    base = os.path.join(work, str(row_number))
    with open(base + ".spectrum", encoding="utf-8") as file:
        spectrum = [line.split() for line in file]
    lines = [(float(order), float(amplitude)) for order, amplitude in spectrum]
    named = spectrum_labels.named_lines(lines, int(row["order"]), float(row["comb_spacing"]), highest)
    with open(base + ".labels", "w", encoding="utf-8") as file:
        file.writelines(f"{spectrum[i][0]} {spectrum[i][1]} {name}\n" for i, name in named)


def see_x_and_y(config):
    """Whether sensors 0 and 1 read x and y, as they do of a Jeffcott rotor."""
    angles = [config.get(f"rotor.sensors.{i}.angle_deg") for i in (0, 1)]
    if angles == [None, None]:
        return config.get("rotor.kind") == "jeffcott"
    return None not in angles and [configuration.number(angle) for angle in angles] == [0, 90]


def lay_out_probes(directory, work, row_number, shown, speed_hz, config):
    """What the sensors read, where they looked and see x and y: at instants of their own."""
    readings = os.path.join(directory, "sensors.csv")
    spectrum = os.path.join(directory, "probe_spectrum.csv")
    if not (os.path.exists(readings) and os.path.exists(spectrum) and see_x_and_y(config)):
        return False
    rows = list(csv_table.read_table(readings, "t_s", "sensor_0_m", "sensor_1_m"))
    base = os.path.join(work, str(row_number))
    _write(base + ".probe_history",
           csv_table.between(rows, "t_s", shown.begin / speed_hz, shown.end / speed_hz), "t_s", "sensor_1_m")
    _write(base + ".probe_orbit", csv_table.between(rows, "t_s", shown.orbit_from / speed_hz), "sensor_0_m", "sensor_1_m")
    lines = csv_table.between(csv_table.read_table(spectrum, "order", "amplitude_m"), "order", -LARGEST_ORDER, LARGEST_ORDER)
    _write(base + ".probe_spectrum", lines, "order", "amplitude_m")
    return True


def _write(path, rows, *names):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(" ".join(row[name] for name in names) + "\n" for row in rows)


def _quoted(text):
    return f'"{text}"'
