import os
import shutil
import tempfile
import unittest
from pathlib import Path

import rubsweep

FILE = Path(__file__).resolve().parents[2] / "configs" / "rotors" / "ross_rotor.toml"


class Rotor:
    """A stand-in whose `save` leaves a file of ROSS."""

    def save(self, path):
        shutil.copy(FILE, path)


class Ross(unittest.TestCase):
    def test_a_rotor_is_saved_and_named(self):
        with tempfile.TemporaryDirectory() as directory:
            part = rubsweep.from_ross(Rotor(), Path(directory) / "kit.toml")
            self.assertEqual(part, {"kind": "ross", "file": os.path.realpath(Path(directory) / "kit.toml")})
            self.assertTrue(Path(part["file"]).exists())

    def test_a_file_of_ross_runs(self):
        rotor = {**rubsweep.from_ross(FILE), "damping_ratio": 0.002,
                 "unbalance": [{"disc": "Impeller", "eccentricity_ratio": 1, "eccentricity_phase_deg": 0, "skew_rad_per_m": 0,
                                "skew_phase_deg": 0}]}
        stop = {"kind": "annular", "position_m": 0.6, "clearance_m": 2e-4, "stiffness_n_per_m": 5e7, "restitution": 0.7,
                "contact_radius_m": 0.05}
        rub = rubsweep.run({"rotor": rotor, "stops": [stop], "kick": {"force_n": 2000, "duration_s": 0.002},
                            "sweep": {"speed_hz": {"values": [20, 30]}, "whirl_ratio": {"values": [0.3]}}})
        self.assertEqual(dict(rub.sizes), {"whirl_ratio": 1, "speed_hz": 2})
        self.assertTrue((rub["status"] == "ok").all())
