"""A machine whose maps are counted: its maps by role, and traces of single cells by rubtrace."""

import math
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

from map_cells import read_map
from rubplot import configuration, csv_table
from rubplot.failure import Failure

ROLES = ("one_side", "both_sides", "both_sides_unequal", "annulus", "annulus_offset")


class StudiedMap:
    """A directory with map.csv and config.yaml, as rubsweep leaves it."""

    def __init__(self, directory):
        self.config_file = os.path.join(directory, "config.yaml")
        self.values = configuration.read_configuration(self.config_file)
        self.cells = read_map(os.path.join(directory, "map.csv"), self.number("rotor.natural_frequency_hz"))

    def number(self, path):
        if path not in self.values:
            raise configuration.ConfigurationError(f"{self.config_file} has no {path}")
        return configuration.number(self.values[path])

    def gap_share(self):
        """The clearance of the first stop less its offset."""
        offset = configuration.numbers(self.values.get("stops.0.offset_m", "[0, 0]"))
        return 1 - math.hypot(*offset) / self.number("stops.0.clearance_m")


class StudiedMachine:
    """`directories` are the maps it has, by role."""

    def __init__(self, name, directories, rubtrace):
        self.name = name
        self.maps = {role: StudiedMap(directory) for role, directory in directories.items()}
        self.memory = {}  # what several findings share
        self._rubtrace = rubtrace

    def cells(self, role):
        return self.maps[role].cells

    def ratios(self, role):
        return {cell.ratio for cell in self.cells(role)}

    def each(self, function, cells):
        """The function of each cell, several at a time: most of it is waiting for rubtrace."""
        with ThreadPoolExecutor(os.cpu_count()) as threads:
            return list(threads.map(function, cells))

    def trajectory(self, role, cell, names, revolutions=None, last_revolutions=None):
        """These columns of its trajectory, as numbers: of so many revolutions from the kick on, or of the last ones."""
        arguments = ["--last-revolutions", str(last_revolutions)] if last_revolutions else []
        if revolutions:
            arguments += ["--set", f"response.max_revolutions={revolutions}"]
        return self._trace(role, cell, arguments, "trajectory.csv", names)

    def spectrum(self, role, cell):
        """(order, amplitude in m) of its full spectrum."""
        return self._trace(role, cell, ["--last-revolutions", "1"], "spectrum.csv", ("order", "amplitude_m"))

    def _trace(self, role, cell, arguments, file, names):
        with tempfile.TemporaryDirectory() as directory:
            command = [self._rubtrace, self.maps[role].config_file, "--quiet", "--output", directory, *arguments]
            command += ["--speed-hz", repr(cell.speed_hz), "--whirl-ratio", repr(cell.ratio)]
            if subprocess.run(command, check=False).returncode:
                raise Failure(f"rubtrace failed: {' '.join(command)}")
            rows = csv_table.read_table(os.path.join(directory, file), *names)
            return [tuple(csv_table.number(row, name) for name in names) for row in rows]
