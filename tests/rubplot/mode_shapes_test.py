import unittest

import figures
import rotor_report_fixture


class ModeShapes(rotor_report_fixture.ReportTest):
    def test_each_mode_is_named(self):
        self.expect_clear("mode-shapes", "Pump: Mode shapes", "mode 1, critical at 38 Hz (2280 rpm), backward",
                          "mode 2, critical at 38 Hz (2280 rpm), forward", "place along the shaft (mm)", "x", "y")

    def test_many_modes_leave_each_other_room(self):
        lines = rotor_report_fixture.shapes().split("\n")
        for mode in range(3, 9):
            lines = lines[:-1] + [f"{mode}{line[1:]}".replace(",38,38,", f",0,{10 * mode},") for line in lines if line.startswith("1,")] + [""]
        self.write("mode_shapes.csv", "\n".join(lines))
        self.expect_clear("mode-shapes", "mode 6, 60 Hz at 0 Hz (0 rpm), backward")

    def test_a_rotor_without_a_shaft_has_no_shapes(self):
        self.write("mode_shapes.csv", "mode,whirl,speed_hz,frequency_hz,position_m,x_real,x_imag,y_real,y_imag\n1,forward,30,30,0,1,0,0,-1\n")
        code, _, complaint = figures.rubplot("mode-shapes", self.directory)
        self.assertEqual(code, 3)
        self.assertIn("no shaft whose shape could be drawn", complaint)


if __name__ == "__main__":
    unittest.main()
