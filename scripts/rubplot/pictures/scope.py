"""A recording as rubscope sees it: of a steady speed orbit, lines and speed, of a run-up Bode plot, polar plot and orders."""

import math
import os

from rubplot import csv_table, domain_map, phases, shown_units
from rubplot.failure import require_readable
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

LEAST_SHARE = 1e-3  # of the largest line of all spectra: smaller ones are not drawn


class Scope:
    """A directory that rubscope wrote. Lengths are drawn about the centre of the orbit."""

    def __init__(self, directory):
        files = {name: os.path.join(directory, f"{name}.csv") for name in ("orbit", "turns", "lines", "measures")}
        require_readable(*files.values())
        rows = {name: list(csv_table.read_table(path)) for name, path in files.items()}
        self.plane = bool(rows["orbit"]) and "y_m" in rows["orbit"][0]
        self._number = csv_table.number
        self.orbit = [self._place(row, "turns") for row in rows["orbit"]]
        self.centre = tuple(sum(point[i] for point in self.orbit) / len(self.orbit) for i in range(2))
        self.section = [(*self._place(row, "turn"), self._number(row, "t_s"), self._number(row, "speed_hz")) for row in rows["turns"]]
        self.lines = [tuple(self._number(row, name) for name in ("order", "amplitude_m", "uncertainty_m")) for row in rows["lines"]]
        self.measures = {row["quantity"]: row["value"] for row in rows["measures"]}
        self.simulated, self.simulated_lines = self._compared(directory)
        largest = max(abs(value - self.centre[i]) for point in self.orbit for i, value in enumerate(point))
        self.per_metre, self.unit = shown_units.of_length(largest)

    def _place(self, row, along):
        """x and y of two probes; of one the turns of the shaft stand in for x."""
        x = self._number(row, "x_m")
        return (x, self._number(row, "y_m")) if self.plane else (self._number(row, along), x)

    def _compared(self, directory):
        """Orbit and lines (order, amplitude) of the motion that --compare simulated; none without it."""
        orbit, lines = (os.path.join(directory, name) for name in ("simulated.csv", "compared.csv"))
        if not os.path.exists(orbit):
            return [], []
        require_readable(orbit, lines)
        return (
            [self._place(row, "turns") for row in csv_table.read_table(orbit)],
            [(self._number(row, "order"), self._number(row, "simulated_m")) for row in csv_table.read_table(lines)],
        )

    def simulated_orbit(self):
        """About its own centre, which is 0."""
        for x, y in self.simulated + (self.simulated[:1] if self.plane else []):
            yield f"{self.per_metre * x if self.plane else x:.17g} {self.per_metre * y:.17g}"

    def simulated_spectrum(self):
        for order, amplitude in self.simulated_lines:
            yield f"{order:.17g} {self.per_metre * amplitude:.17g}"

    def _shown(self, point):
        """In `unit` about the centre; of one probe the first number stays as it is."""
        first = self.per_metre * (point[0] - self.centre[0]) if self.plane else point[0]
        return f"{first:.17g} {self.per_metre * (point[1] - self.centre[1]):.17g}"

    def closed_orbit(self):
        """The mean period; of two probes with its first point again at the end."""
        yield from map(self._shown, self.orbit + (self.orbit[:1] if self.plane and "period_turns" in self.measures else []))

    def marks(self):
        """The section; of one probe, whose orbit is drawn over turns, at the turns of its period."""
        period = int(self.measures.get("period_turns", len(self.section)))
        for turn, point in enumerate(self.section):
            yield self._shown(point[:2] if self.plane else (turn % period, point[1]))

    def spectrum(self):
        """Order, amplitude and its standard uncertainty in `unit`, without 0X."""
        for order, amplitude, uncertainty in self.lines:
            if order:
                yield f"{order:.17g} {self.per_metre * amplitude:.17g} {self.per_metre * uncertainty:.17g}"

    def speed(self):
        for *_, t_s, speed_hz in self.section:
            yield f"{t_s:.17g} {shown_units.axis({}, 'speed_hz').factor * speed_hz:.17g}"

    def label(self):
        period = self.measures.get("period_turns")
        return "no period" if period is None else f"period {period} turn" + "s" * (period != "1")

    def widest(self):
        """Half the side of the square that holds orbit and section."""
        points = self.orbit + [point[:2] for point in self.section]
        measured = max(math.hypot(x - self.centre[0], y - self.centre[1]) for x, y in points)
        return 1.1 * self.per_metre * max([measured] + [math.hypot(x, y) for x, y in self.simulated])


class ScopeRun:
    """A directory that rubscope wrote of a run-up or coast-down."""

    def __init__(self, directory):
        files = {name: os.path.join(directory, f"{name}.csv") for name in ("bode", "waterfall", "measures")}
        require_readable(*files.values())
        self._number = csv_table.number
        rows = list(csv_table.read_table(files["bode"]))
        self.directions = [name for name in "xy" if f"{name}_amplitude_m" in rows[0]]
        self.orders = sorted({self._number(row, "order") for row in rows})
        self._rows = {order: [row for row in rows if self._number(row, "order") == order] for order in self.orders}
        self._waterfall = list(csv_table.read_table(files["waterfall"]))
        measures = {row["quantity"]: row["value"] for row in csv_table.read_table(files["measures"])}
        per_hz = shown_units.axis({}, "speed_hz").factor
        self.resonances = sorted({"%.4g" % (per_hz * float(measures[f"resonance_{name}_hz"])) for name in self.directions if f"resonance_{name}_hz" in measures}, key=float)
        largest = max(self._number(row, f"{name}_amplitude_m") for row in rows for name in self.directions)
        self.per_metre, self.unit = shown_units.of_amplitude(largest)
        self.speed = shown_units.axis({}, "speed_hz")

    def curve(self, order, direction):
        """Speed, amplitude, phase (which goes on where it passes a whole turn), and both as x and y of a polar plot."""
        before = -90  # a lag of half a turn below and above a resonance
        for row in self._rows[order]:
            amplitude = self.per_metre * self._number(row, f"{direction}_amplitude_m")
            phase = self._number(row, f"{direction}_phase_deg")
            if phase is None:  # of a run-up without a mark
                yield f"{self.speed.factor * self._number(row, 'speed_hz'):.17g} {amplitude:.17g} nan nan nan"
                continue
            angle = math.radians(phase)
            before = phase = phases.beside(phase, before)
            yield f"{self.speed.factor * self._number(row, 'speed_hz'):.17g} {amplitude:.17g} {phase:.17g} {amplitude * math.cos(angle):.17g} {amplitude * math.sin(angle):.17g}"

    def spectra(self):
        """The lines that are seen: order, half their distance, speed, the speeds between which a spectrum is drawn,
        amplitude; the largest last, on top."""
        lines = [tuple(self._number(row, name) for name in ("order", "speed_hz", "amplitude_m")) for row in self._waterfall]
        if not lines:
            return
        orders = sorted({order for order, _, _ in lines})
        half = min((b - a for a, b in zip(orders, orders[1:])), default=1) / 2
        edges = domain_map.edges(self.speed.factor * speed for _, speed, _ in lines)
        largest = max(amplitude for *_, amplitude in lines)
        for order, speed, amplitude in sorted(lines, key=lambda line: line[2]):
            if amplitude >= LEAST_SHARE * largest:
                shown = self.speed.factor * speed
                yield " ".join("%.17g" % number for number in (order, half, shown, *edges[shown], self.per_metre * amplitude))

    def files(self):
        curves = [(order, direction) for order in self.orders[:4] for direction in self.directions]
        files = {f"curve_{i}": self.curve(*curve) for i, curve in enumerate(curves)}
        files["names.gp"] = [f'name_{i} = "{order:g}X, {direction}"' for i, (order, direction) in enumerate(curves)]
        phased = all(row[f"{direction}_phase_deg"] for rows in self._rows.values() for row in rows for direction in self.directions)
        files["names.gp"].append(f"phased = {int(phased)}")
        files["spectra"] = self.spectra()
        return len(curves), files


def run_picture(given):
    run = ScopeRun(given.source)
    count, files = run.files()
    return Picture("scope_run.gp", (given.heading, str(count), run.unit, " ".join(run.resonances), run.speed.label), files)


def picture(given):
    if not os.path.exists(os.path.join(given.source, "orbit.csv")):
        return run_picture(given)
    scope = Scope(given.source)
    return Picture(
        "scope.gp",
        (
            given.heading,
            scope.label(),
            scope.unit,
            "1" if scope.plane else "0",
            "%.17g" % scope.widest() if scope.plane else "0",
            "1" if scope.simulated else "0",
            shown_units.axis({}, "speed_hz").label,
        ),
        {
            "orbit": scope.closed_orbit(),
            "section": scope.marks(),
            "spectrum": scope.spectrum(),
            "speed": scope.speed(),
            "simulated": scope.simulated_orbit(),
            "simulated_spectrum": scope.simulated_spectrum(),
        },
    )


SUBCOMMAND = Subcommand(
    name="scope",
    summary="a recorded motion (rubscope)",
    description="""Draws what rubscope wrote into DIR: the mean period of the recorded motion with the position of the shaft
at each passage of the mark, the lines of its full spectrum over their noise, the speed over time, and the simulated motion
of --compare. Of a run-up: amplitude and phase over the speed, a polar plot, and full spectra in orders.""",
    source="DIR",
    heading="Recording",
    picture=picture,
    units=("speed", "length", "peak_to_peak"),
    examples=("measured_scope", "measured_scope --heading 'Kit 2, Monday'"),
)
