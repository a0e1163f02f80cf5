"""continuous_integration_test.py TOP PROGRAMS: the shell of the job in docs/continuous-integration.md does what it says, and the
workflow of this repository names scripts, targets, labels, packages and files that are there. No runner of the service is
needed for it."""

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


def text_of(*parts):
    with open(os.path.join(TOP, *parts), encoding="utf-8") as file:
        return file.read()


# Releases of the service's own actions that are known to be there.
ACTIONS = {"actions/checkout@v4", "actions/upload-artifact@v4"}


class Workflow(unittest.TestCase):
    def setUp(self):
        self.text = text_of(".github", "workflows", "debian.yaml")

    def steps(self):
        try:
            import yaml
        except ImportError:  # Debian: python3-yaml
            self.skipTest("no module yaml")
        # YAML 1.1 takes the key `on` for a truth value; the service does not.
        read = yaml.load(self.text, yaml.BaseLoader)
        self.assertEqual(sorted(read), ["jobs", "name", "on"])
        (job_read,) = read["jobs"].values()
        self.assertEqual(job_read["container"], "debian:12")
        return job_read["steps"]

    def test_each_step_is_a_shell_or_an_action_that_is_there(self):
        for step in self.steps():
            self.assertTrue(set(step) <= {"name", "run", "uses", "with", "if"}, step)
            self.assertEqual(("run" in step) + ("uses" in step), 1, step)
            if "uses" in step:
                self.assertIn(step["uses"], ACTIONS)
            else:
                checked = subprocess.run(["bash", "-n"], input=step["run"], text=True, capture_output=True)
                self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_its_packages_are_in_the_distribution(self):
        if shutil.which("apt-cache") is None:
            self.skipTest("no apt-cache")
        lines = self.text.replace("\\\n", " ").splitlines()
        named = [word for line in lines for word in re.split("bootstrap.sh|--no-install-recommends", line)[1:]]
        packages = [word for words in named for word in words.split() if re.fullmatch("[a-z][a-z0-9+-]+", word)]
        self.assertIn("lintian", packages)
        self.assertIn("git", packages)
        known = subprocess.run(["apt-cache", "pkgnames"], capture_output=True, text=True).stdout.split()
        if len(known) < 10000:
            self.skipTest("apt-get update was never run here")
        self.assertEqual([name for name in packages if name not in known], [])

    def test_its_preset_builds_where_its_files_are_taken_from(self):
        self.assertEqual(set(re.findall(r"--preset (\w+)", self.text)), {"release"})
        self.assertIn('"name": "release"', text_of("CMakePresets.json"))
        self.assertIn('"binaryDir": "${sourceDir}/build/${presetName}"', text_of("CMakePresets.json"))
        taken = set(re.findall(r"build/release/\S+", self.text))
        self.assertEqual(taken, {"build/release/rubsweep_*.deb", "build/release/rubsweep-dev_*.deb", "build/release/docs/site/",
                                 "build/release/*.deb", "build/release/*.tar.gz"})
        packages = text_of("packaging", "packages.cmake")
        self.assertIn("PROGRAMS_PACKAGE_NAME rubsweep)", packages)
        self.assertIn("DEVELOPMENT_PACKAGE_NAME rubsweep-dev)", packages)
        self.assertIn("FILE_NAME DEB-DEFAULT", packages)  # NAME_VERSION_ARCHITECTURE.deb
        self.assertIn("set(site ${CMAKE_CURRENT_BINARY_DIR}/site)", text_of("docs", "CMakeLists.txt"))

    def test_labels_that_its_tests_leave_out_are_there(self):
        left_out = re.search("-LE '([^']*)'", text_of("scripts", "test.sh"))[1].split("|")
        self.assertIn("scripts/test.sh", self.text)
        lists = "".join(text_of(os.path.relpath(os.path.join(folder, name), TOP))
                        for folder, _, names in os.walk(os.path.join(TOP, "tests")) for name in names
                        if name == "CMakeLists.txt")
        for label in left_out:
            self.assertRegex(lists, rf'LABELS "?([a-z;]*;)?{label}\b')

    def test_it_tries_the_package_as_the_package_test_does(self):
        tried = re.search(r"first_map.sh (.*)", self.text)[1]
        self.assertIn(f"first_map.sh {tried}'", text_of("tests", "packaging", "installed_and_purged.sh"))
        self.assertIn("RUBSWEEP_TUTORIAL", text_of("tests", "documents", "tutorial_test.py"))

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
