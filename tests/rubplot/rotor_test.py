import os
import unittest

import figures
import rotor_report_fixture
from rubplot import lanes
from rubplot.pictures import rotor


class Rotor(rotor_report_fixture.ReportTest):
    def test_the_picture_names_the_parts_of_the_file(self):
        self.expect_clear("rotor", "Pump: Rotor", "radius (mm)", "Drive end", "Free end", "Seal 'A'", "disc 0", "stop 0",
                          "probe 0, 1", "bearing", "seal", "stop", "probe")

    def test_crowded_parts_have_names_in_rows(self):
        more = "".join(f"seal,Seal {k},{0.3 + 0.01 * k},,,,,,,,\nstop,stop {k},{0.6 + 0.003 * k},,,,,,,,\n" for k in range(1, 13))
        self.write("rotor_parts.csv", rotor_report_fixture.PARTS + more)
        self.expect_clear("rotor", "Seal 12", "stop 12", "Free end")

    def test_matrices_tell_no_diameters(self):
        parts = rotor_report_fixture.PARTS.split("\n")
        self.write("rotor_parts.csv", "\n".join([parts[0], "shaft,shaft,0,1,,,,,,,", *parts[5:]]))
        root = self.draw("rotor")
        words = figures.words(root)
        self.assertIn("Drive end", words)
        self.assertNotIn("radius (mm)", words)

    def test_a_rotor_without_shaft_is_refused_with_the_reason(self):
        os.remove(self.path("rotor_parts.csv"))
        self.write("report_notes.csv", "picture,note,from_hz,to_hz\nrotor,left out: a Jeffcott rotor has no shaft,,\n")
        code, _, complaint = figures.rubplot("rotor", self.directory)
        self.assertEqual(code, 3)
        self.assertIn("rotor left out: a Jeffcott rotor has no shaft", complaint)

    def test_a_disc_has_the_size_of_steel(self):
        # 300 mm in diameter and 50 mm wide.
        radius, width = 0.15, 0.05
        mass = rotor.STEEL * 3.141592653589793 * radius**2 * width
        size = rotor.size_of({"mass_kg": mass, "polar_inertia_kg_m2": mass * radius**2 / 2}, 2.0)
        self.assertAlmostEqual(size["radius_m"], radius)
        self.assertAlmostEqual(size["half_width_m"], width / 2)

    def test_too_many_parts_of_a_kind_have_no_names(self):
        parts = [{"element": "disc", "name": f"disc {k}", "position_m": 0.01 * k} for k in range(rotor.MOST_NAMED + 1)]
        self.assertEqual(rotor.named(parts, rotor.ABOVE, 1.0), [])
        self.assertEqual(len(lanes.joined(rotor.named(parts[1:], rotor.ABOVE, 1.0))), rotor.MOST_NAMED)


if __name__ == "__main__":
    unittest.main()
