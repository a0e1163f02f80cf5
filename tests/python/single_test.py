import tempfile
import unittest
from pathlib import Path

import rubsweep

MINIMAL = Path(__file__).resolve().parents[2] / "configs" / "minimal.yaml"


class Single(unittest.TestCase):
    def test_a_trace_has_its_tables_and_leaves_none_behind(self):
        cell = rubsweep.trace(MINIMAL, speed_hz=70, whirl_ratio=0.2, revolutions=8)
        self.assertEqual(sorted(cell), ["events", "motion", "section", "spectrum", "trajectory"])
        self.assertEqual(len(cell["section"]), 9)
        self.assertEqual(cell["trajectory"].attrs["units"]["vx_m_per_s"], "m/s")
        self.assertIsNone(cell.directory)
        self.assertIn("motion", cell.text)

    def test_a_line_has_the_values_that_were_asked_for(self):
        line = rubsweep.line(MINIMAL, "speed_hz", (60, 80), 5, passes=("up", "down"), whirl_ratio=0.4)
        self.assertEqual(sorted(set(line["line"]["speed_hz"])), [60, 65, 70, 75, 80])
        self.assertEqual(set(line["line"]["pass"]), {"up", "down"})

    def test_a_branch_and_a_basin(self):
        branch = rubsweep.branch(MINIMAL, cell=(70, 0.4), values=(65, 75))
        self.assertGreaterEqual(branch["branch"]["parameter"].min(), 65)
        self.assertEqual(list(branch["events"]["kind"]), [])
        with tempfile.TemporaryDirectory() as directory:
            basin = rubsweep.basin(MINIMAL, (70, 0.4), ("x", "vx"), (3, 3), first=(-1e-3, -0.2), last=(1e-3, 0.2), output=directory)
            self.assertTrue((basin.directory / "slice.csv").exists())
        self.assertEqual(len(basin["slice"]), 9)
        self.assertAlmostEqual(basin["attractors"]["share"].sum(), 1)

    def test_a_recording_and_a_fit(self):
        with tempfile.TemporaryDirectory() as directory:
            made = rubsweep.trace(MINIMAL, speed_hz=75, whirl_ratio=0.4, output=Path(directory) / "made",
                                  options=("--sample-s", "2e-4", "--noise-m", "1e-6"))
            probes = [{"column": "sensor_0_m", "angle_deg": 0}, {"column": "sensor_1_m", "angle_deg": 90}]
            scope = rubsweep.scope(made.directory / "sensors.csv",
                                   instrument={"time": "t_s", "speed_hz": 75, "from_s": 2, "probes": probes})
            self.assertIn("subharmonic 1/2", scope.text)
            self.assertIn("lines", scope)
            struck = rubsweep.trace(MINIMAL, output=Path(directory) / "struck",
                                    options=("--free-response", "--noise-m", "1e-7"))
            found = rubsweep.fit(MINIMAL, ["rotor.damping_ratio=0.001:0.2"], ring_downs=[struck.directory / "sensors.csv"],
                                 rotor__damping_ratio=0.03)
        self.assertAlmostEqual(found["parameters"]["value"][0], 0.02, delta=1e-3)
