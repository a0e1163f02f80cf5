"""One run of ringstab and what its files say: onsets, critical speeds, real parts, couplings of a chart. Speeds in rpm."""

import os
import re
import subprocess
import tempfile

from rubplot import csv_table
from rubplot.failure import Failure

# The decaying roots that merge, and not those at rest.
DECAYING = r"decaying.*-[0-9][0-9]"


class RingRun:
    def __init__(self, ringstab, config, settings=()):
        """Runs ringstab on a configuration with KEY=VALUE settings and reads what it wrote."""
        with tempfile.TemporaryDirectory() as directory:
            arguments = [part for setting in settings for part in ("--set", setting)]
            done = subprocess.run([ringstab, config, "--output", directory, "--quiet", *arguments], check=False)
            if done.returncode:
                raise Failure(f"ringstab {config} ended with {done.returncode}")
            self._onsets = self._read(directory, "onsets.csv", "kind", "speed_rpm", "modes", "note")
            self._speeds = self._read(directory, "critical_speeds.csv", "name", "closed_form_rpm")
            self._eigenvalues = self._read(directory, "eigenvalues.csv", "speed_rpm", "mode", "real_per_s")
            self._chart = []
            if os.path.exists(os.path.join(directory, "chart_onsets.csv")):
                self._chart = self._read(directory, "chart_onsets.csv", "kind", "speed_rpm", "note")

    @staticmethod
    def _read(directory, name, *columns):
        return list(csv_table.read_table(os.path.join(directory, name), *columns))

    def onset_rows(self, kind, pattern=""):
        """The onsets of this kind whose modes or note match the regular expression."""
        return [row for row in self._onsets if row["kind"] == kind and re.search(pattern, row["modes"] + "," + row["note"])]

    def onset(self, kind, pattern="", which=0):
        """The speed of one of them, None where there are not so many."""
        rows = self.onset_rows(kind, pattern)
        return csv_table.number(rows[which], "speed_rpm") if which < len(rows) else None

    def count(self, kind, pattern=""):
        return len(self.onset_rows(kind, pattern))

    def speed(self, name):
        """A critical speed in closed form."""
        return next(csv_table.number(row, "closed_form_rpm") for row in self._speeds if row["name"] == name)

    def largest_real_part(self, mode, speed_rpm):
        """Growth rate of a mode at one of the speeds that were computed, 1/s."""
        rows = (row for row in self._eigenvalues if row["mode"] == mode and csv_table.number(row, "speed_rpm") == speed_rpm)
        return max(csv_table.number(row, "real_per_s") for row in rows)

    def coupling_regions(self, below_rpm, step_deg):
        """Regions of the chart's angle in which growing roots merge towards a divergence below this speed, as (first,
        last); `step_deg` is the distance of its angles."""
        angles = set()
        for row in self._chart:
            if "growing, divergence" in row["note"] and csv_table.number(row, "speed_rpm") < below_rpm:
                angles.add(float(next(iter(row.values()))))  # the first column is named after the parameter
        return join(sorted(angles), 1.5 * step_deg)


def join(values, largest_step):
    """Rising values as (first, last) of every stretch without a step above the largest."""
    regions = []
    for value in values:
        if regions and value - regions[-1][1] <= largest_step:
            regions[-1] = (regions[-1][0], value)
        else:
            regions.append((value, value))
    return regions
