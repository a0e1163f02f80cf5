"""continuous_integration_test.py TOP PROGRAMS: the shell of the job in docs/continuous-integration.md does what it says, and the
workflow of this repository names scripts and targets that are there."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

TOP, PROGRAMS = sys.argv[1:3]
EQUAL, WRONG, DIFFERENT = 0, 2, 5


def job():
    """The lines behind the last `run: |` of the document."""
    with open(os.path.join(TOP, "docs", "continuous-integration.md"), encoding="utf-8") as file:
        text = file.read()
    return re.search(r"run: \|\n((?: {14}.*\n)+)", text)[1]


class Job(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        shutil.copy(os.path.join(TOP, "configs", "minimal.yaml"), os.path.join(self.folder, "machine.yaml"))
        self.run_shell("rubsweep machine.yaml --output kept --quiet")

    def run_shell(self, script):
        """Runs it as a runner does; returns exit code and what was printed."""
        path = os.pathsep.join([PROGRAMS, os.environ["PATH"]])
        done = subprocess.run(["sh", "-e", "-c", script], cwd=self.folder, env={**os.environ, "PATH": path},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout

    def change(self, old, new):
        path = os.path.join(self.folder, "machine.yaml")
        with open(path, encoding="utf-8") as file:
            text = file.read()
        self.assertIn(old, text)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace(old, new))

    def test_the_same_machine_is_equal(self):
        code, said = self.run_shell(job())
        self.assertEqual(code, EQUAL, said)
        self.assertIn("The maps are equal.", said)

    def test_another_kick_differs_and_is_drawn(self):
        self.change("force_n: 200", "force_n: 100")
        code, said = self.run_shell(job())
        self.assertEqual(code, DIFFERENT, said)
        self.assertIn("The maps differ", said)
        with open(os.path.join(self.folder, "difference.png"), "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")

    def test_a_map_of_another_grid_differs(self):
        self.change("count: 6", "count: 7")
        code, said = self.run_shell(job())
        self.assertEqual(code, DIFFERENT, said)

    def test_a_wrong_machine_ends_the_job(self):
        self.change("mass_kg: 0.8", "mass_kg: -1")
        code, said = self.run_shell(job())
        self.assertEqual(code, WRONG, said)
        self.assertIn("rotor.mass_kg", said)


class Workflow(unittest.TestCase):
    def setUp(self):
        with open(os.path.join(TOP, ".github", "workflows", "debian.yaml"), encoding="utf-8") as file:
            self.text = file.read()

    def test_its_scripts_are_there(self):
        scripts = re.findall(r"(?:scripts|tests)/[\w/.]+\.sh", self.text)
        self.assertGreater(len(scripts), 2)
        self.assertEqual([name for name in scripts if not os.access(os.path.join(TOP, name), os.R_OK)], [])

    def test_its_targets_are_there(self):
        made = ""
        for folder in ("docs", "packaging"):
            with open(os.path.join(TOP, folder, "CMakeLists.txt"), encoding="utf-8") as file:
                made += file.read()
        targets = re.findall(r"--target (\w+)", self.text)
        self.assertEqual(sorted(targets), ["docs", "packages"])
        for target in targets:
            self.assertRegex(made, rf"add_custom_target\({target}\b")


if __name__ == "__main__":
    if shutil.which("gnuplot") is None:
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
