"""The identification of a rotor from its free response and its run-up: readings, fitted decay, Bode plot."""

import os
from dataclasses import dataclass

from rubplot import captions, configuration, csv_table
from rubplot.failure import Failure, require_readable
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand


@dataclass(frozen=True)
class Found:
    """A quantity as the first sensor shows it that has one."""

    value: float
    sensor: int


def find(path, quantity):
    """In an identification.csv."""
    for row in csv_table.read_table(path, "quantity", "sensor", "value"):
        if row["quantity"] == quantity:
            return Found(csv_table.number(row, "value"), int(csv_table.number(row, "sensor")))
    raise Failure(f"{path}: no quantity '{quantity}'")


def natural_frequency_hz(directory):
    """As the free response shows it."""
    return find(os.path.join(directory, "free_response", "identification.csv"), "natural_frequency_hz").value


def picture(given):
    names = ("free_response/sensors.csv", "free_response/identification.csv", "run_up/bode.csv", "run_up/identification.csv")
    files = {name: os.path.join(given.source, name) for name in names}
    require_readable(*files.values())
    damping = find(files["free_response/identification.csv"], "damping_ratio")
    resonance = find(files["run_up/identification.csv"], "resonance_frequency_hz")
    config_file = os.path.join(given.source, "run_up", "config.yaml")
    config = configuration.read_configuration(config_file) if os.path.exists(config_file) else {}
    return Picture(
        "identification.gp",
        (
            captions.headed(given.heading, config),
            str(damping.sensor),
            "%.17g" % natural_frequency_hz(given.source),
            "%.17g" % damping.value,
            "%.17g" % resonance.value,
            captions.byline(config),
        ),
        {
            "free": _columns(files["free_response/sensors.csv"], "t_s", f"sensor_{damping.sensor}_m"),
            "bode": _columns(files["run_up/bode.csv"], "speed_hz", "sensor_0_amplitude_m", "sensor_0_phase_deg",
                             "sensor_1_amplitude_m", "sensor_1_phase_deg"),
        },
    )


def _columns(path, *names):
    return (" ".join(row[name] for name in names) for row in csv_table.read_table(path, *names))


SUBCOMMAND = Subcommand(
    name="identification",
    summary="what an impulse and a run-up find of a rotor (rubtrace --free-response, --run-up)",
    description="""Draws what rubtrace --free-response wrote into DIR/free_response and rubtrace --run-up into DIR/run_up: the
readings of a sensor with the fitted decay, and the component that turns with the shaft.""",
    source="DIR",
    heading="Rotor kit",
    picture=picture,
    examples=("results/rotor_kit", "results/rotor_kit --output identification.pdf"),
)
