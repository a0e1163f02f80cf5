"""A fit of rubfit: the data of each file beside the model, and the numbers that were found."""

import cmath
import math
import os

from rubplot import configuration, csv_table, phases, shown_units
from rubplot.failure import Failure, require_readable
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

# Most files of data, and sensors of each, that a picture shows; more would not be told apart.
MOST_FILES, MOST_SENSORS = 3, 4
# Titles of the panels of a file, and the axis of its points where that is no speed.
_KINDS = {
    "ring_down": ("ring-down", shown_units.Axis("time (s)")),
    "run_up": ("1X on a ramp", None),
    "steady": ("1X at steady speeds", None),
    "rub": ("lines of a rub", shown_units.Axis("order")),
}


class FittedFile:
    """One file of data; `series` holds for each sensor the rows (at, measured, modelled), complex but of a ring-down."""

    def __init__(self, rows, config):
        self.kind = rows[0]["kind"]
        if self.kind not in _KINDS:
            raise Failure(f"fitted.csv: a kind of data called '{self.kind}', allowed: {', '.join(_KINDS)}")
        self.title, axis = _KINDS[self.kind]
        self.axis = axis or shown_units.axis(config, "speed_hz")
        parts = {}
        for row in rows:
            both = tuple(csv_table.number(row, name) for name in ("measured_m", "modelled_m"))
            parts.setdefault(row["sensor"], {}).setdefault(row["part"], []).append((self.axis.factor * csv_table.number(row, "at"), *both))
        self.series = {sensor: self._joined(found) for sensor, found in sorted(parts.items(), key=lambda item: int(item[0]))}
        largest = max(abs(value) for rows_of in self.series.values() for _, *both in rows_of for value in both)
        self.per_metre, self.unit = shown_units.of_length(largest)
        left = max(abs(measured - model) for rows_of in self.series.values() for _, measured, model in rows_of)
        self.left_per_metre, self.left_unit = shown_units.of_length(left) if left > 0 else (self.per_metre, self.unit)

        self.left_step = self._step(self.left_per_metre * left)

    @staticmethod
    def _step(largest):
        """1, 2 or 5 times a power of ten, at most half of a number: a low panel has room for few numbers."""
        if not largest > 0:
            return 1
        power = 10 ** math.floor(math.log10(largest / 2))
        return max(share * power for share in (1, 2, 5) if share * power <= largest / 2 or share == 1)

    @staticmethod
    def _joined(parts):
        if "signal" in parts:
            return parts["signal"]
        return [(at, complex(real, imaginary[0]), complex(model, imaginary[1]))
                for (at, real, model), (_, *imaginary) in zip(parts["real"], parts["imaginary"])]

    def leaves_nothing(self):
        """Whether a ring-down is fitted to the last bit, so that what is left has no range."""
        return self.kind == "ring_down" and all(measured == model for rows in self.series.values() for _, measured, model in rows)

    def upper(self, sensor):
        """The reading, or the amplitude: at, measured, modelled."""
        for at, measured, modelled in self.series[sensor]:
            values = (measured, modelled) if self.kind == "ring_down" else (abs(measured), abs(modelled))
            yield " ".join("%.17g" % number for number in (at, *(self.per_metre * value for value in values)))

    def lower(self, sensor):
        """Residual of a reading; of 1X the phases, which go on where they pass a whole turn, and what is left."""
        before = None
        for at, measured, modelled in self.series[sensor]:
            if self.kind == "ring_down":
                yield f"{at:.17g} {self.left_per_metre * (measured - modelled):.17g} nan"
                continue
            model = phases.beside(math.degrees(cmath.phase(modelled)), before)
            before = None if self.kind == "rub" else model
            phase = phases.beside(math.degrees(cmath.phase(measured)), model)
            yield f"{at:.17g} {phase:.17g} {model:.17g} {self.left_per_metre * abs(measured - modelled):.17g}"


class Fit:
    """A directory that rubfit wrote."""

    def __init__(self, directory):
        files = {name: os.path.join(directory, f"{name}.csv") for name in ("fitted", "parameters")}
        written = os.path.join(directory, "config.yaml")
        require_readable(*files.values(), written)
        config = configuration.read_configuration(written)
        rows = {}
        for row in csv_table.read_table(files["fitted"], "data", "kind", "sensor", "part", "at", "measured_m", "modelled_m"):
            rows.setdefault(int(row["data"]), []).append(row)
        if not rows:
            raise Failure(f"{files['fitted']}: holds no data")
        self.files = [FittedFile(rows[number], config) for number in sorted(rows)][:MOST_FILES]
        self.left_out = len(rows) - len(self.files)
        self.found = [self._sentence(row) for row in csv_table.read_table(files["parameters"])]

    @staticmethod
    def _sentence(row):
        value, low, high = (csv_table.number(row, name) for name in ("value", "low_95", "high_95"))
        half = (high - low) / 2
        if not math.isfinite(half):
            return f"{row['parameter']} = {value:.6g}, not told"
        return f"{row['parameter']} = {value:.6g} ± {half:.2g}" + (" (at its bound)" if row["at_bound"] == "1" else "")


def picture(given):
    fit = Fit(given.source)
    files, panels = {}, []
    for column, data in enumerate(fit.files):
        sensors = list(data.series)[:MOST_SENSORS]
        panels += [f'title_{column} = "{data.title}"', f'axis_{column} = "{data.axis.label}"', f'unit_{column} = "{data.unit}"', f'left_unit_{column} = "{data.left_unit}"',
                   f'kind_{column} = "{data.kind}"', f"sensors_{column} = {len(sensors)}", f"nothing_left_{column} = {int(data.leaves_nothing())}", f"left_step_{column} = {data.left_step:.17g}"]
        for i, sensor in enumerate(sensors):
            panels.append(f'name_{column}_{i} = "sensor {sensor}"')
            files[f"upper_{column}_{i}"] = data.upper(sensor)
            files[f"lower_{column}_{i}"] = data.lower(sensor)
    more = max(0, fit.left_out)
    found = fit.found + ([f"{more} more file{'s' if more > 1 else ''} of data not shown"] if more else [])
    panels.append(f"found = {len(found)}")
    panels += [f'found_{i} = "{sentence}"' for i, sentence in enumerate(found)]
    files["panels.gp"] = panels
    return Picture("fit.gp", (given.heading, str(len(fit.files))), files)


SUBCOMMAND = Subcommand(
    name="fit",
    summary="data and model of a fit (rubfit)",
    description="""Draws what rubfit wrote into DIR: of each file of data, three at most, the readings or the amplitude and
phase of 1X as points and the fitted model as lines, what is left of both, of a rub the lines of its spectrum; below,
the numbers that were found with half the width of their 95 % intervals.""",
    source="DIR",
    heading="Fit",
    picture=picture,
    units=("speed", "length"),
    examples=("results/kit_fit", "results/kit_fit --output fit.svg --heading 'Kit 2, Monday'"),
)
