"""columns_test.py PROGRAMS TOP: what `rubsweep --columns` says of the tables of all programs is what these write: small runs of
each program, every column of every table that they leave, every column that is listed, and the words in columns with words.

PROGRAMS is the directory of the programs.
"""

import collections
import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

programs, top = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])

STUDY = """\
recordings: 4
recordings_per_machine: 4
machine: {mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: 0.02, clearance_m: 3.0e-4}
speed_ratio: [1.95, 2.05]
candidates: [{kind: one_side, whirl_ratio: [0.9, 1.5]}]
measurement: {turns: 32, sampling_rate_hz: 5000, noise_share: 2.0e-3}
split: {training: 1, validation: 0, test: 0}
output: {directory: set}
"""
MAP = ["sweep.speed_hz={values: [74, 75, 76]}", "sweep.whirl_ratio={values: [0.4, 0.5, 0.6]}"]
# Names that stand for several columns.
PLACES = {"N": r"\d+", "K": r"\d+", "UNBALANCE": "(?:whirl_ratio|eccentricity_m)", "PARAMETER": r"\w+"}
# Words that no small run meets; each of them is said by a test of its own part.
RARE = {"status", "from", "to", "kind", "meeting", "finding", "attribution", "verdict", "proof", "closing", "start", "orbit",
        "whirl", "state", "pass", "quantity", "check", "reference", "source", "element"}
# Tables whose further columns are those of a map, keys or numbers of the study.
OPEN = {("rubtrace", "motion.csv"), ("rubline", "line.csv"), ("rubbasin", "map.csv"), ("rubbasin", "slice.csv"),
        ("rubbasin", "attractors.csv"), ("rubfit", "correlation.csv")}


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.reader(line for line in file if not line.startswith("#")))


def pattern(name):
    """A regular expression of the columns that a listed name stands for."""
    return re.compile("_".join(PLACES.get(part, re.escape(part)) for part in name.split("_")) + r"\Z")


class ColumnsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.work)
        text = subprocess.run([programs / "rubsweep", "--columns"], check=True, capture_output=True, text=True).stdout
        cls.listed = list(csv.DictReader(text.splitlines()))
        cls.run_all()
        # All tables by program and file: headers, and the words of each column.
        cls.written = collections.defaultdict(lambda: collections.defaultdict(set))
        for program, name, path in cls.tables():
            header, *rows = rows_of(path)
            for i, column in enumerate(header):
                cls.written[program, name][column] |= {row[i] for row in rows}

    @classmethod
    def program(cls, name, *arguments, allowed=(0,)):
        done = subprocess.run([programs / name, *map(str, arguments), "--quiet"], cwd=cls.work, capture_output=True, text=True)
        if done.returncode not in allowed:
            raise AssertionError(f"{name} {arguments}: exit code {done.returncode}: {done.stderr}")

    @classmethod
    def run_all(cls):
        minimal, one_side, kit = (top / "configs" / f"{name}.yaml" for name in ("minimal", "benchmark/one_side", "rotor_kit"))
        cls.program("rubtrace", minimal, "--speed-hz", 90, "--whirl-ratio", 0.6, "--revolutions", 40, "--output", "rubtrace/a")
        cls.program("rubtrace", kit, "--speed-hz", 70, "--whirl-ratio", 0.6, "--revolutions", 40, "--sample-s", 1e-3,
                    "--output", "rubtrace/kit")
        cls.program("rubtrace", top / "configs/gallery/torsion.yaml", "--speed-hz", 90, "--eccentricity-m", 1e-4, "--revolutions", 20,
                    "--output", "rubtrace/twist")
        cls.program("rubtrace", minimal, "--speed-hz", 90, "--whirl-ratio", 0.6, "--revolutions", 20, "--sample-s", 1e-3,
                    "--probe", "stop0:velocity:90", "--probe", "stop0:acceleration:90", "--output", "rubtrace/casing")
        cls.program("rubtrace", minimal, "--free-response", "--duration-s", 1, "--noise-m", 5e-6, "--output", "rubtrace/free")
        cls.program("rubtrace", minimal, "--run-up", "22:40:6", "--eccentricity-m", 1e-5, "--output", "rubtrace/up")
        cls.program("rubtrace", minimal, "--run-up", "50:60:5", "--eccentricity-m", 2e-4, "--with-stops", "--output", "rubtrace/rub")
        cls.program("rubtrace", kit, "--campbell", "0:100:3", "--output", "rubtrace/campbell")
        cls.program("rubtrace", kit, "--rotor-report", "rubtrace/report")
        cls.program("rubtrace", minimal, "--design-check", "--operating-hz", "50:60", "--kick-speeds", 1,
                    "--other-end", "rotor.damping_ratio=0.05", "--output", "rubtrace/design")
        cls.program("rubline", minimal, "--along", "speed_hz", "--from", 80, "--to", 90, "--count", 3, "--whirl-ratio", 0.6,
                    "--kick", "--up", "--output", "rubline/a")
        cls.program("rubbranch", one_side, "--cell", "75,0.4", "--from", 74, "--to", 76, "--curve", "whirl_ratio",
                    "--curve-from", 0.39, "--curve-to", 0.41, "--output", "rubbranch/a")
        cls.program("rubsweep", one_side, "--set", MAP[0], "--set", MAP[1], "--output", "rubsweep/a")
        cls.program("rubsweep", one_side, "--set", MAP[0], "--set", MAP[1], "--set", "stops.0.restitution=0.5", "--output",
                    "rubsweep/b")
        cls.program("rubbranch", "--map", "rubsweep/a", "--output", "rubbranch/map", allowed=(0, 4))
        cls.program("rubbasin", one_side, "--cell", "75,0.4", "--grid", "3x3", "--output", "rubbasin/a")
        cls.program("rubbench", minimal, "--cell", "90,0.6", "--labels", "0x0", "--turns", 6, "--repeats", 1, "--steppers",
                    "dopri5", "--tolerances", 1e-6, "--output", "rubbench/a")
        (cls.work / "rubsweep-compare").mkdir()
        cls.program("rubsweep-compare", "rubsweep/a/map.csv", "rubsweep/b/map.csv", "--cells", "rubsweep-compare/--cells FILE",
                    allowed=(0, 5))
        cls.program("ringstab", top / "configs/ring/figure10.yaml", "--output", "ringstab/a")
        cls.program("ringstab", top / "configs/ring/figure15.yaml", "--set", "chart.over={values: [0, 0.1]}", "--output",
                    "ringstab/chart", allowed=(0, 2, 4))
        cls.measure(minimal)

    @classmethod
    def measure(cls, minimal):
        """Programs for what is measured: on recordings of rubdata, and on experiments of rubtrace."""
        (cls.work / "study.yaml").write_text(STUDY)
        cls.program("rubdata", "study.yaml")
        recordings = sorted((cls.work / "set/training").rglob("*.csv"))
        labels = {row["file"]: row["rubs"] for row in csv.DictReader(
            line for line in (cls.work / "set/labels.csv").read_text().splitlines() if not line.startswith("#"))}
        rubbing = next((path for path in recordings if labels[path.relative_to(cls.work / "set").as_posix()] == "1"), recordings[0])
        shutil.copyfile(rubbing, cls.work / "run.csv")
        shutil.copyfile(cls.work / "set/instrument.yaml", cls.work / "run.yaml")
        cls.program("rubscope", "run.csv", "--compare", minimal, "--cell", "60,0.9", "--output", "rubscope/a", allowed=(0, 2))
        cls.program("rubdiagnose", "run.csv", "--machine", minimal, "--motions", 50, "--output", "rubdiagnose/a")
        cls.program("rubfit", minimal, "--set", "rotor.natural_frequency_hz=31", "--ring-down", "rubtrace/free/sensors.csv",
                    "--from-s", 0.006, "--fit", "rotor.natural_frequency_hz", "--fit", "hit_s=-0.002:0.002", "--output", "rubfit/a")

    @classmethod
    def tables(cls):
        for folder in cls.work.iterdir():
            if folder.is_dir() and folder.name in {row["program"] for row in cls.listed}:
                for path in folder.rglob("*"):
                    if path.suffix == ".csv" or path.name == "--cells FILE":
                        yield folder.name, path.name, path

    def columns(self, program, file):
        return [row["column"] for row in self.listed
                if (row["program"], row["file"]) == (program, file) and row["column"] and not row["word"]]

    def test_every_table_that_is_written_is_listed(self):
        listed = {(row["program"], row["file"]) for row in self.listed}
        self.assertEqual(set(self.written) - listed, set())
        self.assertEqual(listed - set(self.written), set())

    def test_every_column_that_is_written_is_listed(self):
        in_maps = set(re.findall(r"^  (\w+)  ", subprocess.run([programs / "rubsweep", "--help"], capture_output=True, check=True,
                                                             text=True).stdout, flags=re.MULTILINE))
        wrong = []
        for (program, file), columns in self.written.items():
            names = [pattern(name) for name in self.columns(program, file)]
            known = in_maps if (program, file) in OPEN or file == "map.csv" else set()
            for column in columns:
                if not any(name.match(column) for name in names) and column not in known:
                    wrong.append((program, file, column))
        allowed = {("rubbasin", "slice.csv"), ("rubbasin", "attractors.csv"), ("rubbasin", "map.csv"), ("rubfit", "correlation.csv")}
        self.assertEqual([one for one in wrong if one[:2] not in allowed], [])

    def test_every_column_that_is_listed_is_written(self):
        wrong = [(program, file, name) for program, file in self.written for name in self.columns(program, file)
                 if not any(pattern(name).match(column) for column in self.written[program, file])]
        self.assertEqual(wrong, [])

    def test_words_in_a_column_are_listed(self):
        words = collections.defaultdict(set)
        for row in self.listed:
            if row["word"]:
                words[row["program"], row["file"], row["column"]] |= set(row["word"].split(", "))
        self.assertGreater(len(words), 20)
        for (program, file, column), said in words.items():
            met = {word for cell in self.written[program, file][column] for word in cell.split(";")} - {"", "ok"}
            with self.subTest(program=program, file=file, column=column):
                self.assertEqual(met - said, set())
                self.assertTrue(met or column in RARE, "no run meets a word of it")

    def test_a_set_of_recordings_lists_its_own_columns(self):
        readme = (self.work / "set/README.md").read_text()
        for file, said in (("run.csv", "a recording"), ("set/labels.csv", "labels.csv")):
            listed = readme.split(f"| column of {said} |")[1].split("\n\n")[0]
            self.assertEqual(re.findall(r"^\| `(\w+)` \|", listed, flags=re.MULTILINE), rows_of(self.work / file)[0])

    def test_meanings_are_said_once(self):
        keys = [(row["program"], row["file"], row["column"], row["word"]) for row in self.listed]
        self.assertEqual([key for key, count in collections.Counter(keys).items() if count > 1], [])
        self.assertEqual([row for row in self.listed if not row["meaning"] or None in row or None in row.values()], [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
