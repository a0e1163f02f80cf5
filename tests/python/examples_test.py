"""Every example of examples/python runs, and says what it is about."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]


class Examples(unittest.TestCase):
    def run_example(self, name, *arguments):
        done = subprocess.run([sys.executable, "-B", str(TOP / "examples" / "python" / name), *arguments], cwd=TOP,
                              env=dict(os.environ, MPLBACKEND="Agg"), capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_one_cell(self):
        self.assertIn("subharmonic 1/2", self.run_example("one_cell.py"))

    def test_map(self):
        with tempfile.TemporaryDirectory() as directory:
            try:
                import matplotlib  # noqa: F401
            except ImportError:
                self.skipTest("no matplotlib (Debian package: python3-matplotlib)")
            self.assertIn("largest contact force", self.run_example("map.py", os.path.join(directory, "map.png")))
            self.assertTrue(os.path.getsize(os.path.join(directory, "map.png")) > 5000)

    def test_branch(self):
        self.assertIn("fold", self.run_example("branch.py"))

    def test_recording(self):
        said = self.run_example("recording.py")
        self.assertIn("subharmonic 1/2", said)
        self.assertIn("one_side", said)

    def test_all_examples_are_tried(self):
        self.assertEqual({path.stem for path in (TOP / "examples" / "python").glob("*.py")},
                         {"one_cell", "map", "branch", "recording"})


unittest.main()
