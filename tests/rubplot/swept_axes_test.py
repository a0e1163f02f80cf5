import unittest

from rubplot import configuration, swept_axes

FIXED = {"sweep.speed_hz.values": "[75]", "sweep.whirl_ratio.values": "[0.4]"}


class SweptAxes(unittest.TestCase):
    def test_speed_and_unbalance_are_the_plane_of_a_map_without_keys(self):
        self.assertEqual(swept_axes.plane(FIXED), ("speed_hz", "whirl_ratio"))
        by_eccentricity = {"sweep.speed_hz.values": "[75]", "sweep.eccentricity_m.values": "[1e-5, 2e-5]"}
        self.assertEqual(swept_axes.plane(by_eccentricity), ("speed_hz", "eccentricity_m"))

    def test_keys_with_several_values_are_drawn(self):
        one = FIXED | {"sweep.x.key": "kick.force_n", "sweep.x.values": "[1, 2]"}
        self.assertEqual(swept_axes.plane(one), ("kick.force_n", "speed_hz"))
        two = one | {"sweep.y.keys": "[stops.0.restitution, a]", "sweep.y.values": "[0.5, 0.6]"}
        self.assertEqual(swept_axes.plane(two), ("kick.force_n", "stops.0.restitution"))
        with_speed = one | {"sweep.speed_hz.values": "[75, 80]"}
        self.assertEqual(swept_axes.plane(with_speed), ("speed_hz", "kick.force_n"))

    def test_a_picture_has_room_for_two(self):
        three = {
            "sweep.speed_hz.values": "[75, 80]",
            "sweep.whirl_ratio.values": "[0.4, 0.5]",
            "sweep.x.key": "a",
            "sweep.x.values": "[1, 2]",
        }
        with self.assertRaisesRegex(configuration.ConfigurationError, "speed_hz, whirl_ratio, a"):
            swept_axes.plane(three)

    def test_an_axis_by_its_ends_and_in_other_units_is_the_same_column(self):
        config = {
            "sweep.speed_rpm.from": "3000",
            "sweep.speed_rpm.to": "12000",
            "sweep.speed_rpm.count": "4",
            "sweep.unbalance_g_mm.from": "1",
            "sweep.unbalance_g_mm.to": "100",
            "sweep.unbalance_g_mm.count": "3",
            "sweep.unbalance_g_mm.scale": "log",
        }
        self.assertEqual(swept_axes.plane(config), ("speed_hz", "eccentricity_m"))


if __name__ == "__main__":
    unittest.main()
