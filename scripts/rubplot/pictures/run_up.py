"""A run-up or run-down through rub: orbits, envelope, where it rubs, and the spectrogram over orders."""

import math
import os

from rubplot import captions, configuration, csv_table, domain_map, shown_units
from rubplot.failure import Failure, require_readable
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

LEAST_ORDERS = 2
LEAST_SHARE = 0.02  # of the largest line: the spectrogram goes on to the last order with so large a one


def picture(given):
    names = ("envelope.csv", "orbits.csv", "spectrogram.csv", "quasi_static.csv", "rub.csv", "config.yaml")
    files = {name: os.path.join(given.source, name) for name in names}
    require_readable(*files.values())
    config = configuration.read_configuration(files["config.yaml"])
    speed = shown_units.axis(config, "speed_hz")
    envelope = _rows(files["envelope.csv"], "speed_hz", "lowest_y_m", "highest_y_m", "peak_displacement_m")
    if not envelope:
        raise Failure(f"{files['envelope.csv']}: no row")
    steady = _rows(files["quasi_static.csv"], "speed_hz", "peak_displacement_m")
    orbits = _rows(files["orbits.csv"], "orbit", "speed_hz", "x_m", "y_m")
    lines = _rows(files["spectrogram.csv"], "speed_hz", "order", "amplitude_m")
    spans = list(csv_table.read_table(files["rub.csv"], "source", "from_hz", "to_hz"))
    clearance = 1e3 * configuration.number(config["stops.0.clearance_m"])
    angle = configuration.number(config["stops.0.angle_deg"]) if "stops.0.angle_deg" in config else math.nan
    reach = 1e3 * max((math.hypot(x, y) for _, _, x, y in orbits), default=1e-3)
    return Picture(
        "run_up.gp",
        (
            captions.headed(given.heading, config),
            _span_of_speeds(config, [speed.factor * row[0] for row in envelope]),
            "%.17g %.17g" % (clearance, angle),
            orbit_speeds(orbits, speed.factor),
            "%.17g" % (1.1 * max(reach, clearance)),
            "%d" % largest_order(lines),
            captions.byline(config),
        ),
        {
            "envelope": (_line(speed.factor * hz, *(1e3 * value for value in rest)) for hz, *rest in envelope),
            "steady": (_line(speed.factor * hz, 1e3 * peak) for hz, peak in steady if peak is not None),
            "orbits": orbit_lines(orbits),
            "spectrogram": spectrogram_lines([(speed.factor * hz, *rest) for hz, *rest in lines]),
            "rub": rub_lines(spans, speed.factor),
        },
    )


def _span_of_speeds(config, speeds):
    return "%.17g %.17g %s" % (min(speeds), max(speeds), "rpm" if shown_units.in_rpm(config) else "Hz")


def orbit_speeds(orbits, factor=1):
    """The speeds of the orbits in their order, to four digits."""
    speeds = [factor * hz for number, hz, _, _ in orbits if number is not None]
    return " ".join("%.4g" % speed for i, speed in enumerate(speeds) if i == 0 or speed != speeds[i - 1])


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


SUBCOMMAND = Subcommand(
    name="run-up",
    summary="run-up or run-down through rub (rubtrace --run-up --with-stops)",
    description="""Draws what rubtrace --run-up --with-stops wrote into DIR: a strip of orbits, the envelope with the steady
motions, where it rubs, and the spectrogram over orders.""",
    source="DIR",
    heading="Run-up through rub",
    picture=picture,
    units=("speed",),
    examples=("results/my_run_up", "results/my_run_down --heading 'Run-down through rub' --output run_down.pdf"),
)
