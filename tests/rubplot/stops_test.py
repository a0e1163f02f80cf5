import unittest

from rubplot import stops


class Stops(unittest.TestCase):
    def test_flat_and_annular(self):
        found = stops.read_stops({
            "stops.0.kind": "annular", "stops.0.clearance_m": "2e-3", "stops.0.offset_m": "[1e-3, -5e-4]",
            "stops.1.kind": "one_side", "stops.1.clearance_m": "1e-3", "stops.1.angle_deg": "0",
            "stops.1.casing.mass_kg": "1",
            "stops.2.kind": "one_side", "stops.2.clearance_m": "1e-3", "stops.2.angle_deg": "90",
        })
        self.assertEqual(found.rings, [(-1e-3, 5e-4, 2e-3)])
        self.assertEqual(found.walls[0], (1, 0, 1e-3))
        self.assertEqual(found.levels, [-1.5e-3, 2.5e-3, 1e-3])
        self.assertEqual(found.moving, [], "a wall that moves sideways, and a rigid one")

    def test_a_stop_elsewhere_along_the_shaft_is_seen_by_its_gap(self):
        found = stops.read_stops({
            "stops.0.kind": "one_side", "stops.0.clearance_m": "1e-3", "stops.0.angle_deg": "270",
            "stops.0.position_m": "0.3", "stops.0.casing.mass_kg": "1",
            "stops.1.kind": "one_side", "stops.1.clearance_m": "2e-3", "stops.1.angle_deg": "10", "stops.1.position_m": "0.2",
            "rotor.sensors.0.position_m": "0.2",
        })
        self.assertEqual(len(found.walls), 1)
        self.assertEqual(found.elsewhere, [("gap_0_m", "casing_0_y_m", -1e-3)])
        self.assertEqual(found.places, "seen at 200 mm, stop 0 at 300 mm")

    def test_without_sensors_the_first_stop_is_where_the_rotor_is_seen(self):
        stop = {"kind": "one_side", "clearance_m": "1e-3", "angle_deg": "90"}
        config = {f"stops.{i}.{key}": value for i in (0, 1) for key, value in stop.items()}
        config |= {"stops.0.position_m": "0.3", "stops.1.position_m": "0.35"}
        config["stops.1.name"] = '"seal: 2"'
        found = stops.read_stops(config)
        self.assertEqual([len(found.walls), len(found.elsewhere)], [1, 1])
        self.assertEqual(found.places, "seen at 300 mm, stop 1 (seal: 2) at 350 mm")
