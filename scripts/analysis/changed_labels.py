"""The program behind changed_labels.sh, which says what it does."""

import collections
import os
import subprocess
import tempfile

from command import run_program
from rubplot import csv_table
from rubplot.configuration import number, read_configuration
from rubplot.failure import Failure

KICK, TURNS = "kick.force_n", "response.max_revolutions"
KICK_CHANGES = (0.0, *(sign * size for size in (1e-10, 3e-10, 1e-9, 3e-9, 1e-8) for sign in (1, -1)))
COLUMNS = ("speed_hz", "whirl_ratio", "class", "order", "orbit")


def label(row):
    """The label that a map gives a cell: class, order and orbit."""
    order = f"1/{row['order']}" if row["class"] == "subharmonic" and row["order"] else ""
    orbit = "" if row["class"] in ("non_contact", "chaotic", "unsettled") else row["orbit"]
    return " ".join(part for part in (row["class"], order, orbit) if part)


def changed_cells(before, after):
    """(speed, unbalance, label before, label after) of the cells that two maps of the same grid call by other names, speed
    and unbalance as the maps write them. Raises Failure where the grids differ."""
    maps = [_labels_by_cell(path) for path in (before, after)]
    if list(maps[0]) != list(maps[1]):
        raise Failure(f"{before} and {after} have other cells")
    return [(*cell, old, maps[1][cell]) for cell, old in maps[0].items() if old != maps[1][cell]]


def _labels_by_cell(path):
    return {(row["speed_hz"], row["whirl_ratio"]): label(row) for row in csv_table.read_table(path, *COLUMNS)}


def rounding_decides(labels_before, labels_after):
    """Whether, of the labels that each program gives for several kicks, its own one first, one program has that of the other,
    or each has several."""
    if labels_after[0] in labels_before or labels_before[0] in labels_after:
        return True
    return len(set(labels_before)) > 1 and len(set(labels_after)) > 1


def counted(labels):
    """'chaotic 8; non_contact 3', the most frequent first."""
    return "; ".join(f"{name} {count}" for name, count in collections.Counter(labels).most_common())


class Rerun:
    """Runs single cells of a map again by the program that made it."""

    def __init__(self, program, directory):
        self.program = program
        self.config = os.path.join(directory, "config.yaml")
        self.map = os.path.join(directory, "map.csv")
        values = read_configuration(self.config)
        for key in (KICK, TURNS):
            if key not in values:
                raise Failure(f"{self.config}: no {key}")
        self.force_n, self.turns = number(values[KICK]), int(values[TURNS])

    def labels(self, speed_hz, whirl_ratio, expected):
        """The labels of a cell with each of the kicks. Raises Failure where its own kick does not give the expected one."""
        labels = [self._label(speed_hz, whirl_ratio, {KICK: self.force_n * (1 + change)}) for change in KICK_CHANGES]
        if labels[0] != expected:
            raise Failure(f"{self.map}: {speed_hz} Hz and {whirl_ratio} is {expected}, {self.program} says {labels[0]}")
        return labels

    def longer(self, speed_hz, whirl_ratio):
        """The label of a cell that may take four times as many turns."""
        return self._label(speed_hz, whirl_ratio, {TURNS: 4 * self.turns})

    def _label(self, speed_hz, whirl_ratio, changes):
        with tempfile.TemporaryDirectory() as work:
            values = {
                "sweep.speed_hz": f"{{values: [{speed_hz}]}}",
                "sweep.whirl_ratio": f"{{values: [{whirl_ratio}]}}",
                **changes,
            }
            command = [self.program, self.config, "--output", work, "--quiet", "--threads", "1"]
            for key, value in values.items():
                command += ["--set", f"{key}={value}"]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode not in (0, 4):
                raise Failure(f"{' '.join(command)} ends with {done.returncode}: {done.stderr.strip()}")
            return label(next(csv_table.read_table(os.path.join(work, "map.csv"), *COLUMNS)))


def changed_line(before, after, cell, old, new):
    """One line of CSV on a cell that two Reruns call by other names."""
    labels_before, labels_after = before.labels(*cell, old), after.labels(*cell, new)
    if rounding_decides(labels_before, labels_after):
        by = "rounding"
    elif before.longer(*cell) == new or after.longer(*cell) == old:
        by = "turns"
    else:
        by = "program"
    speed_hz, whirl_ratio = map(float, cell)
    return f"{speed_hz:g},{whirl_ratio:.3f},{old},{new},{counted(labels_before)},{counted(labels_after)},{by}"


def main(arguments):
    before, after = Rerun(*arguments[:2]), Rerun(*arguments[2:])
    print("speed_hz,whirl_ratio,before,after,before_by_kicks,after_by_kicks,decided_by")
    for *cell, old, new in changed_cells(before.map, after.map):
        print(changed_line(before, after, cell, old, new), flush=True)


if __name__ == "__main__":
    run_program(main, usage="changed_labels.sh RUBSWEEP_BEFORE MAP_BEFORE RUBSWEEP_AFTER MAP_AFTER", least=4, most=4)
