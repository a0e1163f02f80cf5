import unittest

import figures
import rotor_report_fixture
from rubplot.pictures import deflected_shape


class DeflectedShape(rotor_report_fixture.ReportTest):
    def test_the_picture_says_what_it_shows(self):
        self.expect_clear("deflected-shape", "Pump: Deflected shape", "at 50 Hz (3000 rpm) with an eccentricity of 3 µm",
                          "half of the major axis (µm)", "orbits", "shaft at one instant", "bearing", "place along the shaft (mm)")

    def test_a_disc_without_a_shaft_has_one_orbit(self):
        self.write("deflected_shape.csv", "position_m,x_real,x_imag,y_real,y_imag\n0,1e-6,0,0,-1e-6\n")
        root = self.expect_clear("deflected-shape", "orbit of the disc", "x (µm)", "y (µm)")
        self.assertNotIn("shaft at one instant", figures.words(root))

    def test_an_orbit_closes(self):
        points = deflected_shape.plain_orbit((0.0, 1e-6 + 0j, -1e-6j), 1e6)
        self.assertEqual([round(float(number), 9) for number in points[0].split()],
                         [round(float(number), 9) for number in points[-1].split()])


if __name__ == "__main__":
    unittest.main()
