import os
import stat

from files import FileTest
from ring_run import DECAYING, RingRun, join
from rubplot.failure import Failure

# A ringstab that says what it was asked and writes known files.
PROGRAM = """#!/bin/sh
[ "$1" != bad.yaml ] || exit 2
cat >"$3/onsets.csv" <<'CSV'
kind,speed_rpm,modes,note
real_merger,224.5,ring forward,"decaying, at -0.35 1/s"
real_merger,1060.25,a,"decaying, at -11.2 1/s"
real_merger,1139,a,growing
CSV
printf 'name,closed_form_rpm,numeric_rpm\\nomega_t,954.9,955\\n' >"$3/critical_speeds.csv"
printf 'speed_rpm,mode,real_per_s\\n100,a,-1\\n100,a,0.5\\n100,b,9\\n200,a,7\\n' >"$3/eigenvalues.csv"
cat >"$3/chart_onsets.csv" <<'CSV'
angle_deg,kind,speed_rpm,note
87,real_merger,1000,"growing, divergence"
87.5,real_merger,1000,"growing, divergence"
88,real_merger,1300,"growing, divergence"
90,real_merger,1000,"growing, divergence"
CSV
"""


class Run(FileTest):
    def ringstab(self):
        path = self.write("ringstab", PROGRAM)
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
        return path

    def test_reads_what_the_program_wrote(self):
        run = RingRun(self.ringstab(), "some.yaml")
        self.assertEqual(run.onset("real_merger"), 224.5)
        self.assertEqual(run.onset("real_merger", "", 1), 1060.25)
        self.assertEqual(run.onset("real_merger", DECAYING), 1060.25)
        self.assertIsNone(run.onset("real_merger", "growing", 1))
        self.assertEqual(run.count("real_merger", "ring forward"), 1)
        self.assertEqual(run.speed("omega_t"), 954.9)
        self.assertEqual(run.largest_real_part("a", 100), 0.5)
        self.assertEqual(run.coupling_regions(1270, 0.5), [(87, 87.5), (90, 90)])

    def test_a_failure_is_named(self):
        with self.assertRaisesRegex(Failure, "bad.yaml ended with 2"):
            RingRun(self.ringstab(), "bad.yaml")


class Join(FileTest):
    def test_stretches_without_a_large_step(self):
        self.assertEqual(join([1, 1.5, 2, 4, 5], 0.75), [(1, 2), (4, 4), (5, 5)])
        self.assertEqual(join([], 1), [])
