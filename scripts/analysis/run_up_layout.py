"""What run_up.gp needs of a run-up or run-down through rub."""

import math
import os

import configuration
import csv_table
import domain_map
import shown_units
from command import Failure, require_readable

LEAST_ORDERS = 2
LEAST_SHARE = 0.02  # of the largest line: the spectrogram goes on to the last order with so large a one


def lay_out(directory, work):
    """Writes work/{envelope,steady,orbits,spectrogram,rub} in mm and Hz; returns the numbers that run_up.gp takes."""
    names = ("envelope.csv", "orbits.csv", "spectrogram.csv", "quasi_static.csv", "rub.csv", "config.yaml")
    files = {name: os.path.join(directory, name) for name in names}
    require_readable(*files.values())
    config = configuration.read_configuration(files["config.yaml"])
    speed = shown_units.axis(config, "speed_hz")
    envelope = _rows(files["envelope.csv"], "speed_hz", "lowest_y_m", "highest_y_m", "peak_displacement_m")
    if not envelope:
        raise Failure(f"{files['envelope.csv']}: no row")
    _write(work, "envelope", (_line(speed.factor * row[0], *(1e3 * value for value in row[1:])) for row in envelope))
    steady = _rows(files["quasi_static.csv"], "speed_hz", "peak_displacement_m")
    _write(work, "steady", (_line(speed.factor * hz, 1e3 * peak) for hz, peak in steady if peak is not None))
    orbits = _rows(files["orbits.csv"], "orbit", "speed_hz", "x_m", "y_m")
    _write(work, "orbits", orbit_lines(orbits))
    lines = _rows(files["spectrogram.csv"], "speed_hz", "order", "amplitude_m")
    _write(work, "spectrogram", spectrogram_lines([(speed.factor * hz, *rest) for hz, *rest in lines]))
    spans = list(csv_table.read_table(files["rub.csv"], "source", "from_hz", "to_hz"))
    _write(work, "rub", rub_lines(spans, speed.factor))
    titles = [speed.factor * hz for number, hz, _, _ in orbits if number is not None]
    orbit_speeds = [shown for i, shown in enumerate(titles) if i == 0 or shown != titles[i - 1]]
    reach = 1e3 * max((math.hypot(x, y) for _, _, x, y in orbits), default=1e-3)
    clearance = 1e3 * configuration.number(config["stops.0.clearance_m"])
    return {
        "speeds": "%.17g %.17g %s" % (speed.factor * min(row[0] for row in envelope),
                                       speed.factor * max(row[0] for row in envelope),
                                       "rpm" if shown_units.in_rpm(config) else "Hz"),
        "clearance": "%.17g" % clearance,
        "angle": "%.17g" % (configuration.number(config["stops.0.angle_deg"]) if "stops.0.angle_deg" in config else math.nan),
        "orbits": " ".join("%.4g" % speed for speed in orbit_speeds),
        "reach": "%.17g" % (1.1 * max(reach, clearance)),
        "order": "%d" % largest_order(lines),
    }


def orbit_lines(rows):
    """x and y in mm, a data set for each orbit."""
    last = None
    for number, _, x, y in rows:
        if last is not None and number != last:
            yield ""
            yield ""
        last = number
        yield _line(1e3 * x, 1e3 * y)


def spectrogram_lines(lines):
    """Speed, order, the speeds between which a spectrum is drawn, amplitude in mm; the largest last, on top."""
    edges = domain_map.edges(speed for speed, _, _ in lines) if lines else {}
    for speed, order, amplitude in sorted(lines, key=lambda row: row[2]):
        if order != 0:
            yield _line(speed, order, *edges[speed], 1e3 * amplitude)


def rub_lines(spans, factor=1):
    """Ends of each stretch and 1 for the ramp, 0 for steady motions."""
    for row in spans:
        ends = [factor * csv_table.number(row, name) for name in ("from_hz", "to_hz")]
        yield _line(min(ends), max(ends), 1 if row["source"] == "ramp" else 0)


def largest_order(lines):
    largest = max((amplitude for _, order, amplitude in lines if order != 0), default=0)
    shown = [abs(order) for _, order, amplitude in lines if amplitude > LEAST_SHARE * largest]
    return max(LEAST_ORDERS, math.ceil(max(shown, default=0)))


def _rows(path, *names):
    return [tuple(csv_table.number(row, name) for name in names) for row in csv_table.read_table(path, *names)]


def _line(*numbers):
    return " ".join("%.17g" % number for number in numbers)


def _write(work, name, lines):
    with open(os.path.join(work, name), "w", encoding="utf-8") as file:
        file.writelines(line + "\n" for line in lines)
