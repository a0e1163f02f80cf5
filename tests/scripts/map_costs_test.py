import os
import shutil
import stat
import subprocess

from files import FileTest

SCRIPT = os.path.join(os.path.dirname(__file__), "..", "..", "scripts", "map_costs.sh")


VALGRIND = """#!/bin/sh
while case $1 in --*) true;; *) false;; esac; do shift; done
echo "==1== Collected : $("$@")"
"""


class MapCosts(FileTest):
    """Stand-ins for rubsweep, which says how many instructions it takes, and for valgrind, which counts them; a source
    tree of its own keeps the numbers that a map may cost."""

    def executable(self, name, text):
        path = self.write(name, text)
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
        return os.path.dirname(path)

    def program(self, instructions, name="tree/build/release/apps/rubsweep"):
        return self.executable(name, f"#!/bin/sh\necho {instructions}\n")

    def tree(self, instructions):
        place = self.write("tree/scripts/map_costs.sh", "")
        shutil.copy(SCRIPT, place)
        tree = os.path.dirname(os.path.dirname(place))
        os.makedirs(os.path.join(tree, "results", "golden"), exist_ok=True)
        self.program(instructions)
        return tree

    def run_in(self, tree, *arguments):
        path = self.executable("tools/valgrind", VALGRIND) + os.pathsep + os.environ["PATH"]
        return subprocess.run([os.path.join(tree, "scripts", "map_costs.sh"), *arguments],
                              env=dict(os.environ, PATH=path), capture_output=True, text=True, check=False)

    def test_a_dearer_map_fails_until_its_number_is_accepted(self):
        tree = self.tree(100000)
        self.assertEqual(self.run_in(tree, "--accept").returncode, 0)
        self.assertEqual(self.run_in(tree).returncode, 0)
        self.program(104000)
        dearer = self.run_in(tree)
        self.assertEqual(dearer.returncode, 1)
        self.assertIn("benchmark/one_side has become more than 3 % dearer", dearer.stderr)
        self.assertIn("rotor_kit has become", dearer.stderr)
        self.assertEqual(self.run_in(tree, "--accept").returncode, 0)
        self.assertEqual(self.run_in(tree).returncode, 0)

    def test_a_cheaper_map_passes(self):
        tree = self.tree(100000)
        self.run_in(tree, "--accept")
        self.program(90000)
        cheaper = self.run_in(tree)
        self.assertEqual(cheaper.returncode, 0)
        self.assertRegex(cheaper.stdout, r"benchmark/annulus: \d+ instructions, -10.00 %")

    def test_two_builds_are_compared_map_by_map(self):
        tree = self.tree(100000)
        dearer = self.program(110000, "dearer/rubsweep")
        said = self.run_in(tree, os.path.join(tree, "build/release/apps"), dearer, "1").stdout.splitlines()
        self.assertEqual(len(said), 6)
        for line in said:
            self.assertRegex(line, r"^\w+(/\w+)?: 100000 -> 110000 instructions, \+10\.00 %, processor time x \d+(\.\d+)?$")
