"""A run-up without stops: amplitude and phase of each sensor over the speed."""

import os

from rubplot import captions, configuration, csv_table, phases, shown_units
from rubplot.failure import Failure, require_readable
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

MOST_SENSORS = 8


class Bode:
    """A directory that rubtrace --run-up wrote."""

    def __init__(self, directory):
        files = {name: os.path.join(directory, name) for name in ("bode.csv", "identification.csv", "config.yaml")}
        require_readable(*files.values())
        self.config = configuration.read_configuration(files["config.yaml"])
        self._rows = list(csv_table.read_table(files["bode.csv"], "speed_hz", "sensor_0_amplitude_m", "sensor_0_phase_deg"))
        if not self._rows:
            raise Failure(f"{files['bode.csv']}: no speed, the run-up was too fast for its samples")
        sensors = range(sum(name.endswith("_amplitude_m") for name in self._rows[0]))
        self.sensors = list(sensors)[:MOST_SENSORS]
        self._resonance = {}
        for row in csv_table.read_table(files["identification.csv"], "quantity", "sensor", "value"):
            if row["quantity"] == "resonance_frequency_hz":
                self._resonance[int(csv_table.number(row, "sensor"))] = csv_table.number(row, "value")
        largest_m = max(csv_table.number(row, f"sensor_{i}_amplitude_m") for row in self._rows for i in self.sensors)
        self.speed = shown_units.axis(self.config, "speed_hz")
        self.per_metre, self.unit = shown_units.of_amplitude(largest_m)

    def lines(self, sensor):
        """Speed, amplitude in `unit`, phase in degrees; the phase goes on where it passes a whole turn."""
        before = None
        for row in self._rows:
            phase = csv_table.number(row, f"sensor_{sensor}_phase_deg")
            before = phase = phases.beside(phase, before)
            amplitude = self.per_metre * csv_table.number(row, f"sensor_{sensor}_amplitude_m")
            yield f"{self.speed.factor * csv_table.number(row, 'speed_hz'):.17g} {amplitude:.17g} {phase:.17g}"

    def names(self):
        """Words of the legend for each sensor: where it looks and along which angle."""
        for sensor in self.sensors:
            angle = self.config.get(f"rotor.sensors.{sensor}.angle_deg")
            place = self.config.get(f"rotor.sensors.{sensor}.position_m")
            where = [f"sensor {sensor}"]
            if place is not None:
                where.append("at %.4g mm" % (1e3 * configuration.number(place)))
            if angle is not None:
                where.append("%.4g°" % configuration.number(angle))
            yield ", ".join(where)

    def resonances(self):
        """The resonances fitted to the sensors that show one, each once to four digits."""
        return sorted({"%.4g" % (self.speed.factor * speed) for sensor, speed in self._resonance.items() if sensor in self.sensors}, key=float)


def picture(given):
    bode = Bode(given.source)
    files = {f"sensor_{i}": bode.lines(i) for i in bode.sensors}
    files["names.gp"] = [f'name_{i} = "{name}"' for i, name in zip(bode.sensors, bode.names())]
    return Picture(
        "bode.gp",
        (
            captions.headed(given.heading, bode.config),
            str(len(bode.sensors)),
            bode.unit,
            " ".join(bode.resonances()),
            captions.byline(bode.config),
            bode.speed.label,
        ),
        files,
    )


SUBCOMMAND = Subcommand(
    name="bode",
    summary="Bode plot of a run-up without stops (rubtrace --run-up)",
    description="""Draws what rubtrace --run-up wrote into DIR: a Bode plot of every sensor, amplitude and phase of the
component that turns with the shaft over its speed.""",
    source="DIR",
    heading="Run-up without stops",
    picture=picture,
    units=("speed", "length", "peak_to_peak"),
    examples=("results/my_run_up", "results/my_run_up --formats png,pdf"),
)
