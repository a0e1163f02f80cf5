import os
import stat

from files import FileTest
from map_cells import COLUMNS
from rubplot.configuration import ConfigurationError
from rubplot.failure import Failure
from sample_machine import cell
from studied_machine import StudiedMachine

CONFIG = """\
rotor:
  natural_frequency_hz: 20
stops:
  - kind: annular
    offset_m: [0.0003, 0.0004]
    clearance_m: 0.001
"""
# A rubtrace that writes what it was asked.
PROGRAM = """#!/bin/sh
config=$1
asked="$*"
while [ "$1" != --output ]; do shift; done
directory=$2
echo "$asked" >"$config.asked"
printf 't_s,gap_0_m,y_m\\n0,1,2\\n0.5,,4\\n' >"$directory/trajectory.csv"
printf 'order,frequency_hz,amplitude_m\\n-1,20,0.5\\n' >"$directory/spectrum.csv"
"""


class Machine(FileTest):
    def setUp(self):
        super().setUp()
        self.config = self.write("annulus/config.yaml", CONFIG)
        self.write("annulus/map.csv", ",".join(COLUMNS) + "\n50,0.2,non_contact,,circle,,0,0,1e-4,0,1,0.2,\n")
        program = self.write("rubtrace", PROGRAM)
        os.chmod(program, os.stat(program).st_mode | stat.S_IXUSR)
        self.machine = StudiedMachine("sample", {"annulus": self.path("annulus")}, program)

    def test_its_maps(self):
        self.assertEqual([one.speed for one in self.machine.cells("annulus")], [2.5])
        self.assertEqual(self.machine.ratios("annulus"), {0.2})
        self.assertAlmostEqual(self.machine.maps["annulus"].gap_share(), 0.5)

    def test_a_value_that_is_not_there_is_named(self):
        with self.assertRaisesRegex(ConfigurationError, "annulus/config.yaml has no kick.force_n"):
            self.machine.maps["annulus"].number("kick.force_n")

    def test_traces(self):
        one = cell(2.5, 0.1, "chaotic")
        rows = self.machine.trajectory("annulus", one, ("y_m", "t_s"), revolutions=128)
        self.assertEqual(rows, [(2, 0), (4, 0.5)])
        asked = self.read("annulus/config.yaml.asked")
        for argument in ("--set response.max_revolutions=128", "--speed-hz 75.0", "--whirl-ratio 0.1"):
            self.assertIn(argument, asked)
        self.assertEqual(self.machine.spectrum("annulus", one), [(-1, 0.5)])
        self.assertIn("--last-revolutions 1", self.read("annulus/config.yaml.asked"))

    def test_a_trace_that_fails_is_named(self):
        machine = StudiedMachine("sample", {"annulus": self.path("annulus")}, "/bin/false")
        with self.assertRaisesRegex(Failure, "rubtrace failed: /bin/false .*--speed-hz 75.0"):
            machine.spectrum("annulus", cell(2.5, 0.1, "chaotic"))

    def test_each_keeps_the_order(self):
        self.assertEqual(self.machine.each(lambda x: x * x, range(5)), [0, 1, 4, 9, 16])
