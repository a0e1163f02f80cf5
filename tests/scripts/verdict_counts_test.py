import io
import os
import stat
from contextlib import redirect_stdout

import verdict_counts
from files import FileTest
from rubplot.failure import Failure


class VerdictCounts(FileTest):
    def test_labels_and_verdicts_have_the_order_of_subharmonics(self):
        self.assertEqual(verdict_counts.label({"class": "subharmonic", "order": "3"}), "subharmonic 1/3")
        self.assertEqual(verdict_counts.label({"class": "non_contact", "order": ""}), "non_contact")
        self.assertEqual(verdict_counts.verdict("speed     70 Hz\nmotion    subharmonic 1/3, oval orbit\n"), "subharmonic 1/3")
        self.assertEqual(verdict_counts.verdict("motion    quasi_periodic: repeats after no\n"), "quasi_periodic")
        self.assertEqual(verdict_counts.verdict("speed     70 Hz\n"), "")

    def set_with(self, program):
        """A stand-in for rubscope, and a set of two recordings."""
        path = self.write("scope.sh", "#!/bin/sh\n" + program)
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
        self.write("labels.csv", "# rubdata\nrecording,file,class,order\n0,a.csv,synchronous,1\n1,b.csv,subharmonic,2\n")
        return [path, os.path.dirname(path)]

    def test_every_recording_counts_once(self):
        arguments = self.set_with('case $1 in *a.csv) echo "motion    synchronous, oval";; *) echo "motion    aperiodic: no";; esac\n')
        heard = io.StringIO()
        with redirect_stdout(heard):
            verdict_counts.main(arguments)
        self.assertEqual(heard.getvalue(), "label,verdict,recordings\nsubharmonic 1/2,aperiodic,1\nsynchronous,synchronous,1\n")

    def test_a_recording_that_is_refused_is_no_verdict(self):
        with self.assertRaises(Failure):
            verdict_counts.main(self.set_with("exit 2\n"))
