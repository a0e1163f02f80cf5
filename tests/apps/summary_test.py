"""summary_test.py APPS CONFIGS: --summary json ends a run of programs with one line of JSON that says how it went."""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

APPS, CONFIGS = sys.argv[1:3]
MINIMAL = os.path.join(CONFIGS, "minimal.yaml")
KEYS = ["program", "version", "exit_code", "seconds", "counts", "warnings", "messages", "files"]
CELL = ("--speed-hz", "70", "--whirl-ratio", "0.4")


class Summary(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def run_program(self, program, *arguments, code=0):
        """The summary, and all lines of standard output before it."""
        ran = subprocess.run([os.path.join(APPS, program), *arguments, "--summary", "json"], cwd=self.folder, text=True,
                             capture_output=True, stdin=subprocess.DEVNULL)
        self.assertEqual(ran.returncode, code, ran.stderr)
        *before, last = ran.stdout.splitlines()
        summary = json.loads(last)
        self.assertEqual(list(summary), KEYS)
        self.assertEqual((summary["program"], summary["exit_code"]), (program, code))
        self.assertGreaterEqual(summary["seconds"], 0)
        self.assertEqual(sorted(summary["warnings"] + summary["messages"]), sorted(filter(None, ran.stderr.splitlines())))
        for path in summary["files"]:
            self.assertTrue(os.path.isabs(path) and os.path.isfile(path), path)
        return summary, before

    def names(self, summary):
        return sorted(os.path.basename(path) for path in summary["files"])

    def test_a_map(self):
        summary, before = self.run_program("rubsweep", MINIMAL, "--output", "map", "--quiet")
        self.assertEqual(before, [])
        self.assertEqual(self.names(summary), ["config.yaml", "map.csv"])
        counts = summary["counts"]
        self.assertEqual(counts.pop("cells"), 24)
        self.assertEqual(sum(counts.values()), 24)
        self.assertEqual(counts["non_contact"], 11)
        self.assertIn("rubsweep: warning: in 2 of 24 cells", " ".join(self.run_program(
            "rubsweep", MINIMAL, "--output", "other")[0]["warnings"]))

    def test_counts_of_other_programs(self):
        gallery = os.path.join(CONFIGS, "gallery")
        stop = os.path.join(CONFIGS, "benchmark", "one_side.yaml")
        basin = self.run_program("rubbasin", os.path.join(gallery, "basin_slice.yaml"), "--cell", "80,0.5", "--plane",
                                 "y,vy", "--grid", "3x3", "--output", "b", "--quiet")[0]
        self.assertEqual(basin["counts"]["starts"], 9)
        branch = self.run_program("rubbranch", stop, "--cell", "75,0.4", "--points", "5", "--output", "c")[0]
        self.assertEqual(branch["counts"]["branches"], 1)
        bench = self.run_program("rubbench", os.path.join(gallery, "work_precision.yaml"), "--cell", "90,0.6", "--labels",
                                 "0x0", "--turns", "6", "--repeats", "1", "--output", "d")[0]
        self.assertGreater(bench["counts"]["measurements"], 5)
        ring = self.run_program("ringstab", os.path.join(gallery, "ring_brake.yaml"), "--output", "e")[0]
        self.assertGreater(ring["counts"]["speeds"], 5)

    def test_files_of_other_programs(self):
        trace = self.run_program("rubtrace", MINIMAL, *CELL, "--revolutions", "30", "--output", "t")[0]
        self.assertIn("trajectory.csv", self.names(trace))
        line = self.run_program("rubline", MINIMAL, "--along", "speed_hz", "--whirl-ratio", "0.4", "--output", "l")[0]
        self.assertEqual(self.names(line), ["bifurcation.csv", "cascade.csv", "config.yaml", "line.csv"])
        self.run_program("rubsweep", MINIMAL, "--output", "a", "--quiet")
        maps = os.path.join("a", "map.csv")
        self.assertEqual(self.run_program("rubsweep-compare", maps, maps)[0]["files"], [])

    def test_measurements_and_reports(self):
        quick = ("--duration-s", "0.3", "--noise-m", "5e-6")
        free = self.run_program("rubtrace", MINIMAL, "--free-response", *quick, "--output", "free", "--quiet")[0]
        self.assertIn("sensors.csv", self.names(free))
        fit = self.run_program("rubfit", MINIMAL, "--ring-down", os.path.join("free", "sensors.csv"), "--from-s", "0.006", "--fit",
                               "rotor.damping_ratio", "--output", "fit", "--quiet")[0]
        self.assertEqual(fit["counts"], {"parameters": 1})
        self.assertEqual(self.names(fit), ["config.yaml", "correlation.csv", "fitted.csv", "parameters.csv"])
        with open(os.path.join(self.folder, "run.csv"), "w", encoding="ascii") as file:
            file.write("t,X\ns,um\n" + "".join(f"{k / 2000},{math.cos(100 * math.pi * k / 2000)}\n" for k in range(2000)))
        with open(os.path.join(self.folder, "run.yaml"), "w", encoding="ascii") as file:
            file.write("time: t\nspeed_hz: 50\nprobes: [{column: X, angle_deg: 0}]\n")
        scope = self.run_program("rubscope", "run.csv", "--output", "seen", "--quiet")[0]
        self.assertIn(scope["counts"]["turns"], (49, 50))
        self.assertIn("measures.csv", self.names(scope))
        self.run_program("rubsweep", MINIMAL, "--output", "map", "--quiet")
        report = self.run_program("rubreport", "map", "--quiet")[0]
        self.assertEqual((report["counts"], self.names(report)), ({"motions": 24}, ["report.html"]))
        both, before = self.run_program("rubsweep", MINIMAL, "--output", "map", "--report")
        self.assertEqual((both["counts"]["motions"], both["counts"]["cells"]), (24, 24))
        self.assertEqual(self.names(both), ["config.yaml", "report.html"])
        self.assertRegex(before[-1], r"^report: map/report.html \([0-9.]+ MB\)$")
        with open(os.path.join(self.folder, "map", "boundaries.csv"), "w", encoding="ascii") as file:
            file.write("speed_hz,height\n")
        refused = self.run_program("rubsweep", MINIMAL, "--output", "map", "--report", "--quiet", code=3)[0]
        self.assertIn("boundaries.csv", " ".join(refused["messages"]))

    def test_sets_of_recordings(self):
        with open(os.path.join(CONFIGS, "recordings", "rub_recordings.yaml"), encoding="utf-8") as file:
            study = file.read().replace("recordings: 500", "recordings: 4").replace("per_machine: 10", "per_machine: 2")
        with open(os.path.join(self.folder, "study.yaml"), "w", encoding="utf-8") as file:
            file.write(study)
        made = self.run_program("rubdata", "study.yaml", "--output", "set", "--quiet")[0]
        self.assertEqual(made["counts"], {"recordings": 4})
        self.assertGreater(len(made["files"]), 4)

    def test_what_is_refused_has_one(self):
        summary, _ = self.run_program("rubsweep", MINIMAL, "--set", "rotor.mass_kg=-1", code=2)
        self.assertEqual((summary["files"], summary["counts"]), ([], {}))
        self.assertIn("rotor.mass_kg", summary["messages"][0])
        self.run_program("rubsweep", "nowhere.yaml", code=3)
        self.run_program("rubsweep", "--verify", self.folder, code=7)

    def test_another_form_is_no_option(self):
        ran = subprocess.run([os.path.join(APPS, "rubsweep"), MINIMAL, "--summary", "xml"], text=True, capture_output=True)
        self.assertEqual((ran.returncode, ran.stdout), (1, ""))
        self.assertIn("--summary: 'xml' is not allowed, allowed: json", ran.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
