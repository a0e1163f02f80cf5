import os
import unittest

import rotor_report_fixture
from rubplot import report_tables
from rubplot.failure import Failure


class ReportTables(rotor_report_fixture.ReportTest):
    def test_remarks_belong_to_their_picture(self):
        self.assertEqual(report_tables.operating_hz(self.directory), (30.0, 50.0))
        self.assertEqual(report_tables.note_text(self.directory, "stability"), "cross-coupling at 0.5 m, at 50 Hz (3000 rpm)")
        self.assertEqual(report_tables.note_text(self.directory, "rotor"), "")

    def test_bearings_are_those_of_the_loads(self):
        self.assertEqual(report_tables.bearings(self.directory), [("Drive end", 0.1), ("Free end", 0.9)])
        os.remove(self.path("bearing_loads.csv"))
        self.assertEqual(report_tables.bearings(self.directory), [])

    def test_what_is_left_out_is_named(self):
        os.remove(self.path("static_line.csv"))
        self.write("report_notes.csv", "picture,note,from_hz,to_hz\nstatic_line,left out: no shaft,,\n")
        with self.assertRaisesRegex(Failure, "static_line left out: no shaft"):
            report_tables.require(self.directory, "static_line.csv", "static_line")


if __name__ == "__main__":
    unittest.main()
