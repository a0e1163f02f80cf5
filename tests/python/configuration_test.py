import json
import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
from rubsweep.configuration import overridden, path_of


class Configuration(unittest.TestCase):
    def written(self, configuration):
        with tempfile.TemporaryDirectory() as directory:
            return json.loads(Path(path_of(configuration, directory)).read_text())

    def test_a_path_stays_what_it_is(self):
        self.assertEqual(path_of(Path("a/b.yaml"), "/nowhere"), "a/b.yaml")

    def test_a_dict_is_written_with_plain_numbers_and_whole_paths(self):
        rotor = {"kind": "ross", "file": Path("r.toml"), "speeds": np.array([1.5, 2]), "n": np.int64(3)}
        self.assertEqual(self.written({"rotor": rotor})["rotor"],
                         {"kind": "ross", "file": os.path.abspath("r.toml"), "speeds": [1.5, 2.0], "n": 3})

    def test_a_sweep_gets_the_directory_that_it_has_to_name(self):
        self.assertEqual(self.written({"sweep": {}})["output"], {"directory": "results"})
        self.assertEqual(self.written({"sweep": {}, "output": {"directory": "x"}})["output"], {"directory": "x"})
        self.assertNotIn("output", self.written({"probes": []}))

    def test_overrides_have_dots_or_two_underscores(self):
        self.assertEqual(overridden({"a.b": 0.5, "stops__0__friction": {"coefficient": np.float64(0.25)}, "c": "text"}),
                         ["--set", "a.b=0.5", "--set", 'stops.0.friction={"coefficient": 0.25}', "--set", "c=text"])

    def test_what_no_configuration_can_hold_is_refused(self):
        with self.assertRaises(TypeError):
            self.written({"rotor": object()})
