"""Findings of rubdiagnose: probabilities, and the recording with the simulated motion that is closest to it."""

import os

from rubplot import csv_table, shown_units
from rubplot.failure import require_readable
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand


class Diagnosis:
    """A directory that rubdiagnose wrote."""

    def __init__(self, directory):
        files = {name: os.path.join(directory, f"{name}.csv") for name in ("probabilities", "orbits", "lines")}
        require_readable(*files.values())
        rows = {name: list(csv_table.read_table(path)) for name, path in files.items()}
        number = csv_table.number
        self.probabilities = [(row["candidate"], number(row, "probability")) for row in rows["probabilities"]]
        self.plane = "y_m" in rows["orbits"][0]
        columns = ("x_m", "y_m") if self.plane else ("turns", "x_m")
        simulated = ("simulated_x_m", "simulated_y_m") if self.plane else ("turns", "simulated_x_m")
        self.recorded, self.simulated = ([tuple(number(row, name) for name in names) for row in rows["orbits"]] for names in (columns, simulated))
        self.lines = [tuple(number(row, name) for name in ("order", "recorded_m", "simulated_m")) for row in rows["lines"]]
        last = 1 if self.plane else 0
        points = self.recorded + self.simulated
        self.largest = max(abs(value) for point in points for value in point[1 - last :])
        self.per_metre, self.unit = shown_units.of_length(self.largest)

    def orbit(self, points):
        for first, second in points:
            yield f"{self.per_metre * first if self.plane else first:.17g} {self.per_metre * second:.17g}"

    def bars(self):
        """From the top: place, percent, name."""
        for place, (name, probability) in enumerate(self.probabilities):
            yield f'{-place} {100 * probability:.17g} "{name}"'

    def spectrum(self):
        for order, recorded, simulated in self.lines:
            yield f"{order:.17g} {self.per_metre * recorded:.17g} {self.per_metre * simulated:.17g}"


def picture(given):
    diagnosis = Diagnosis(given.source)
    return Picture(
        "diagnosis.gp",
        (
            given.heading,
            diagnosis.unit,
            "1" if diagnosis.plane else "0",
            "%.17g" % (1.1 * diagnosis.per_metre * diagnosis.largest),
            str(len(diagnosis.probabilities)),
        ),
        {
            "bars": diagnosis.bars(),
            "recorded": diagnosis.orbit(diagnosis.recorded),
            "simulated": diagnosis.orbit(diagnosis.simulated),
            "spectrum": diagnosis.spectrum(),
        },
    )


SUBCOMMAND = Subcommand(
    name="diagnosis",
    summary="which rub a recording shows (rubdiagnose)",
    description="""Draws what rubdiagnose wrote into DIR: the probability of each candidate and of none of these, and the
recorded motion with the simulated one that is closest to it, as orbits and as lines of their full spectra.""",
    source="DIR",
    heading="Diagnosis",
    picture=picture,
    units=("length",),
    examples=("run7_diagnosis", "run7_diagnosis --heading 'Kit 2, Monday'"),
)
