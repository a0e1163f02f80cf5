import os
import unittest

import figures
import rotor_report_fixture
from rubplot.pictures import critical_map


class CriticalMap(rotor_report_fixture.ReportTest):
    def test_the_picture_says_what_it_shows(self):
        self.expect_clear("critical-map", "Pump: Undamped critical speed map", "stiffness of each bearing (N/m)", "shaft speed (Hz)",
                          "mode 1", "mode 2", "operating range", "Drive end, x; Free end", "Drive end, y")

    def test_without_a_map_the_reason_is_said(self):
        self.write("report_notes.csv", "picture,note,from_hz,to_hz\ncritical_map,left out: no support is a bearing,,\n")
        os.remove(self.path("critical_map.csv"))
        code, _, complaint = figures.rubplot("critical-map", self.directory)
        self.assertEqual(code, 3)
        self.assertIn("left out: no support is a bearing", complaint)

    def test_curves_that_are_the_same_are_one(self):
        a, b = [(10, 1e7), (20, 2e7)], [(10, 1e7), (20, 2.5e7)]
        self.assertEqual(critical_map.merged([("A", a), ("B", b), ("C", a)]), [("A; C", a), ("B", b)])

    def test_modes_that_end_together_share_a_name(self):
        modes = [[(1e4, 10.0), (1e9, 100.0)], [(1e4, 11.0), (1e9, 100.5)], [(1e9, 900.0)]]
        names = list(critical_map.name_lines(modes, 1, 1, 1000))
        self.assertEqual(len(names), 2)
        self.assertIn("modes 1, 2", names[0])


if __name__ == "__main__":
    unittest.main()
