import csv
import re
import tempfile
import unittest
from pathlib import Path

import rubsweep
from rubsweep.figures import motion_kinds
from rubsweep.maps import CLASSES

CONFIGS = Path(__file__).resolve().parents[2] / "configs"
SMALL = {"sweep.speed_hz.count": 5, "response.max_revolutions": 300}


class Maps(unittest.TestCase):
    def test_a_map_has_the_numbers_of_its_table(self):
        with tempfile.TemporaryDirectory() as directory:
            rub = rubsweep.run(CONFIGS / "minimal.yaml", output=directory, threads=1, **SMALL)
            with open(Path(directory) / "map.csv", encoding="utf-8") as file:
                rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        self.assertEqual(dict(rub.sizes), {"whirl_ratio": 4, "speed_hz": 5})
        self.assertEqual(len(rows), 20)
        for row in rows:
            cell = rub.sel(speed_hz=float(row["speed_hz"]), whirl_ratio=float(row["whirl_ratio"]))
            self.assertEqual(str(cell["class"].values), row["class"])
            self.assertEqual(CLASSES[int(cell["class_code"])], row["class"])
            for column in ("peak_displacement_m", "eccentricity_m", "hits_per_revolution", "revolutions"):
                self.assertEqual(float(cell[column]), float(row[column]))
        self.assertEqual(rub["peak_contact_force_n"].units, "N")
        self.assertEqual(rub["speed_hz"].units, "Hz")

    def test_a_dict_with_the_same_keys_gives_the_same_map(self):
        machine = {"rotor": {"kind": "jeffcott", "mass_kg": 0.8, "natural_frequency_hz": 30, "damping_ratio": 0.02},
                   "stops": [{"kind": "one_side", "angle_deg": 90, "clearance_m": 1e-3, "stiffness_n_per_m": 2e6, "restitution": 0.7,
                              "contact_radius_m": 0.0375, "friction": {"stribeck": [0, 0, 0, 0.1, 100, 0]},
                              "casing": {"mass_kg": 0.05, "stiffness_n_per_m": 5e5, "damping_ratio": 0.1}}],
                   "kick": {"force_n": 200, "duration_s": 0.005},
                   "sweep": {"speed_hz": {"from": 50, "to": 150, "count": 6}, "whirl_ratio": {"values": [0.2, 0.4, 0.6, 0.8]}}}
        of_dict = rubsweep.run(machine, sweep__speed_hz__count=3)
        of_file = rubsweep.run(CONFIGS / "minimal.yaml", sweep__speed_hz__count=3)
        self.assertTrue(of_dict.drop_attrs().equals(of_file.drop_attrs()) if hasattr(of_dict, "drop_attrs") else
                        of_dict.equals(of_file))

    def test_bad_input_says_where(self):
        with self.assertRaises(rubsweep.BadInput) as raised:
            rubsweep.run({"rotor": {"kind": "jeffcott", "dampng_ratio": 0.1}})
        problem = [found for found in raised.exception.problems if found.key == "rotor.dampng_ratio"][0]
        self.assertEqual(problem.line, 4)
        self.assertIn("did you mean 'damping_ratio'", problem.text)
        self.assertIn("damping_ratio", problem.allowed)

    def test_the_axes_of_an_eccentricity_are_those_that_were_swept(self):
        rub = rubsweep.run(CONFIGS / "minimal.yaml", **{"sweep": {"speed_hz": {"values": [60, 80]},
                                                                   "eccentricity_m": {"values": [1e-4, 2e-4, 3e-4]}}})
        self.assertEqual(dict(rub.sizes), {"eccentricity_m": 3, "speed_hz": 2})

    def test_a_refined_map_lies_on_the_grid_of_all_its_values(self):
        with tempfile.TemporaryDirectory() as directory:
            path = Path(directory) / "map.csv"
            path.write_text("# head\nspeed_hz,whirl_ratio,class,order\n10,0.1,chaotic,\n20,0.1,subharmonic,2\n15,0.2,synchronous,1\n")
            rub = rubsweep.read_map(directory)
        self.assertEqual(rub["class"].values.tolist(), [["chaotic", "", "subharmonic"], ["", "synchronous", ""]])
        self.assertEqual(int(rub["class_code"].sel(speed_hz=15, whirl_ratio=0.1)), -1)
        self.assertEqual(float(rub["order"].sel(speed_hz=20, whirl_ratio=0.1)), 2)

    def test_classes_are_those_of_the_program(self):
        self.assertEqual({re.sub(r"_(circle.*|\d+|oval|whip)$", "", name) for name in motion_kinds()}, set(CLASSES))
