"""One row of panels of trace.gp: its title and its stops as assignments, its curves as files of columns."""

import math
import os
import re
from dataclasses import dataclass

from rubplot import configuration, csv_table, shown_units, spectrum_labels
from rubplot.failure import Failure, require_readable
from rubplot.stops import read_stops

# The spectrum is drawn to the eighth order; of an oval, which fills a ring as it turns, eight revolutions show how it
# begins.
LARGEST_ORDER = 8
REVOLUTIONS_OF_AN_OVAL = 8
LEAST_ORDER = 2
LEAST_SHARE = 0.01  # of the largest line: the spectra go on to the last order with so large a one

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
    starts_in_state: bool = False  # one that the configuration gives, with nothing before it

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
        starts_in_state=row.get("start") == "state",
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


@dataclass(frozen=True)
class Spans:
    """Revolutions that are shown: history from `begin` to `end`, orbit and section up to the end of the run."""

    begin: int
    end: int
    orbit_from: int
    section_from: int


def spans(motion, first, last, window, revolutions):
    """Layout of a run of `last` revolutions whose trajectory begins with revolution `first`: the history shows so many
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


@dataclass(frozen=True)
class Row:
    """A row of panels: the assignments of its arrays, the lines of its files, and its spectrum as (order, amplitude)."""

    assignments: dict
    files: dict
    spectrum: list

    def label_lines(self, highest):
        """Order, amplitude and name of the lines that are named where the picture goes to the order `highest`."""
        lines = [(float(order), float(amplitude)) for order, amplitude in self.spectrum]
        period, comb_spacing = int(self.assignments["order"]), float(self.assignments["comb_spacing"])
        for i, name in spectrum_labels.named_lines(lines, period, comb_spacing, highest):
            yield f"{self.spectrum[i][0]} {self.spectrum[i][1]} {name}"


def lay_out(directory, revolutions):
    """The row of the trace in a directory."""
    files = {name: os.path.join(directory, name) for name in
             ("trajectory.csv", "section.csv", "spectrum.csv", "motion.csv", "config.yaml")}
    require_readable(*files.values())
    config = configuration.read_configuration(files["config.yaml"])
    motion = read_motion(files["motion.csv"])
    stops = read_stops(config)
    window = int(checked(files["config.yaml"], config["response.window_revolutions"], _WHOLE))
    sections = _read_sections(files["section.csv"])
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
    spectrum = list(_shown_orders(files["spectrum.csv"]))
    lines = {
        "history": _lines(history, "t_s", "x_m", "y_m", *seen),
        "orbit": _lines(orbit, "x_m", "y_m"),
        "section": _lines(csv_table.between(sections, "revolution", shown.section_from), "x_m", "y_m"),
        "spectrum": _lines(spectrum, "order", "amplitude_m"),
    }
    probes = probe_lines(directory, shown, motion.speed_hz, config)
    size_m = max((abs(csv_table.number(row, name)) for row in orbit for name in ("x_m", "y_m")), default=1.0)
    assignments = {
        **_of_motion(motion, config, stops.places),
        **_of_stops(stops, seen, size_m),
        "probed": int(bool(probes)),
        "from": shown.begin,
        "to": shown.end,
        "gravity": checked(files["config.yaml"], config["gravity_m_per_s2"], _NUMBER),
        "kick_s": _kick_s(motion, files["config.yaml"], config),
        "start_y_m": sections[0]["y_m"],
        "start_vy_m_per_s": sections[0]["vy_m_per_s"],
        "highest": highest_order(spectrum),
    }
    return Row(assignments, {**lines, **probes}, [(row["order"], row["amplitude_m"]) for row in spectrum])


def _read_sections(path):
    sections = list(csv_table.read_table(path, "revolution", "x_m", "y_m", "vy_m_per_s"))
    if not sections:
        raise Failure(f"{path}: no row")
    for name in ("y_m", "vy_m_per_s"):
        checked(path, sections[0][name], _NUMBER)
    return sections


def _shown_orders(path):
    return csv_table.between(csv_table.read_table(path, "order", "amplitude_m"), "order", -LARGEST_ORDER, LARGEST_ORDER)


def _of_motion(motion, config, places):
    natural_hz = config.get("rotor.natural_frequency_hz")
    speed = shown_units.speed_text(config, motion.speed_hz)
    return {
        "row_title": _quoted(title(motion, speed, natural_hz and configuration.number(natural_hz), places)),
        "speed_hz": motion.speed,
        "order": motion.order or 0,
        "comb_spacing": motion.comb_spacing or 0,
        "at_rest": int(motion.starts_at_rest),
        "in_state": int(motion.starts_in_state),
    }


def _kick_s(motion, path, config):
    kick_s = checked(path, config.get("kick.duration_s", "0"), _NUMBER)
    return "0" if motion.starts_at_rest else kick_s


def _of_stops(stops, seen, size_m):
    """Walls and levels in the unit of the picture, which shows a motion of this size."""
    per_metre, unit = shown_units.of_length(size_m)

    def lengths(rows, columns=()):
        """All numbers but those at the places `columns`, which are no lengths."""
        return _quoted("".join("%.17g " % (figure if k in columns else per_metre * figure)
                               for row in rows for k, figure in enumerate(row)))

    return {
        "moving_walls": lengths(((_column(seen, name), rest_m) for name, rest_m in stops.moving), {0}),
        "elsewhere": lengths(
            ((_column(seen, gap), _column(seen, casing) if casing else 0, rest_m) for gap, casing, rest_m in stops.elsewhere),
            {0, 1}),
        "levels": lengths((level_m,) for level_m in stops.levels),
        "walls": lengths(stops.walls, {0, 1}),
        "rings": lengths(stops.rings),
        "per_metre": "%g" % per_metre,
        "unit": _quoted(unit),
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


def see_x_and_y(config):
    """Whether sensors 0 and 1 read x and y, as they do of a Jeffcott rotor."""
    angles = [config.get(f"rotor.sensors.{i}.angle_deg") for i in (0, 1)]
    if angles == [None, None]:
        return config.get("rotor.kind") == "jeffcott"
    return None not in angles and [configuration.number(angle) for angle in angles] == [0, 90]


def probe_lines(directory, shown, speed_hz, config):
    """Readings of the sensors, where they looked and see x and y: at instants of their own. Empty where not."""
    readings = os.path.join(directory, "sensors.csv")
    spectrum = os.path.join(directory, "probe_spectrum.csv")
    if not (os.path.exists(readings) and os.path.exists(spectrum) and see_x_and_y(config)):
        return {}
    rows = list(csv_table.read_table(readings, "t_s", "sensor_0_m", "sensor_1_m"))
    history = csv_table.between(rows, "t_s", shown.begin / speed_hz, shown.end / speed_hz)
    orbit = csv_table.between(rows, "t_s", shown.orbit_from / speed_hz)
    return {
        "probe_history": _lines(history, "t_s", "sensor_1_m"),
        "probe_orbit": _lines(orbit, "sensor_0_m", "sensor_1_m"),
        "probe_spectrum": _lines(_shown_orders(spectrum), "order", "amplitude_m"),
    }


def _lines(rows, *names):
    return [" ".join(row[name] for name in names) for row in rows]


def _quoted(text):
    return f'"{text}"'
