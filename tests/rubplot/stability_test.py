import math
import os
import unittest

import figures
import rotor_report_fixture
from rubplot.pictures import stability


class Stability(rotor_report_fixture.ReportTest):
    def test_the_picture_says_what_it_shows(self):
        self.expect_clear("stability", "Pump: Stability", "logarithmic decrement", "shaft speed (Hz)", "cross-coupled stiffness (kN/m)",
                          "cross-coupling at 0.5 m, at 50 Hz (3000 rpm)", "400", "1", "2", "forward whirl", "backward whirl")

    def test_without_a_forward_mode_there_is_the_speed_alone(self):
        os.remove(self.path("stability.csv"))
        note = "no whirl below 240 Hz is forward and lightly damped at 120 Hz (7200 rpm): no decrement over cross-coupling"
        self.write("report_notes.csv", f"picture,note,from_hz,to_hz\nstability,{note},,\n")
        root = self.expect_clear("stability", "shaft speed (Hz)", note)
        self.assertNotIn("cross-coupled stiffness (N/m)", figures.words(root))

    def test_a_decrement_is_that_of_the_damping_ratio(self):
        rows = [{"mode": "1", "whirl": "forward", "speed_hz": "10", "damping_ratio": ratio} for ratio in ("0.5", "1", "-0.01")]
        found = [row["decrement"] for row in stability.decrements(rows)]
        self.assertEqual(len(found), 2, "an overdamped mode has none")
        self.assertAlmostEqual(found[0], 2 * math.pi / math.sqrt(3))
        self.assertLess(found[1], 0)

    def test_zero_is_found_between_rows(self):
        rows = [{"coupling_n_per_m": 0.0, "decrement": 0.3}, {"coupling_n_per_m": 10.0, "decrement": -0.1}]
        self.assertAlmostEqual(stability.crossing(rows), 7.5)
        self.assertIsNone(stability.crossing(rows[:1]))

    def test_strongly_damped_modes_do_not_press_the_others_together(self):
        low, high = stability.limits([0.05, 40.0])
        self.assertLess(low, 0)
        self.assertLess(high, 0.3)


if __name__ == "__main__":
    unittest.main()
