import unittest

import figures
import rotor_report_fixture
from rubplot.pictures import static_line


class StaticLine(rotor_report_fixture.ReportTest):
    def test_the_picture_says_what_it_shows(self):
        self.expect_clear("static-line", "Pump: Static line", "deflection (µm)", "shear force (N)", "bending moment (N m)",
                          "Drive end: 150 N", "Free end: 170 N")

    def test_many_bearings_leave_each_other_room(self):
        rows = "".join(f"Bearing with a long name {k},{0.05 * k},1,-{1000 + k},0\n" for k in range(1, 12))
        self.write("bearing_loads.csv", rotor_report_fixture.LOADS.split("\n")[0] + "\n" + rows)
        self.expect_clear("static-line", "Bearing with a long name 11: 1011 N (x 1, y -1011)")

    def test_without_forces_there_is_the_deflection_alone(self):
        lines = rotor_report_fixture.static_line().split("\n")
        rows = [",".join(line.split(",")[:3]) + ",,,," for line in lines[1:] if line]
        self.write("static_line.csv", "\n".join([lines[0], *rows]) + "\n")
        root = self.expect_clear("static-line", "deflection (µm)")
        self.assertNotIn("shear force (N)", figures.words(root))

    def test_a_load_upwards_says_so(self):
        self.assertEqual(static_line.text_of({"bearing": "A", "load_x_n": 0.0, "load_y_n": 12.0}), "A: 12 N upwards")


if __name__ == "__main__":
    unittest.main()
