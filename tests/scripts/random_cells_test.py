import json
import unittest

from random_cells import random_cell, text_of, with_kits


class RandomCells(unittest.TestCase):
    def test_a_cell_is_the_same_whenever_it_is_drawn(self):
        self.assertEqual(random_cell(3, 17), random_cell(3, 17))
        self.assertNotEqual(random_cell(3, 17), random_cell(3, 18))
        self.assertNotEqual(random_cell(3, 17), random_cell(4, 17))

    def test_what_makes_cells_dear_is_among_them(self):
        cells = [random_cell(1, number) for number in range(400)]
        stops = [stop for cell in cells for stop in cell["stops"]]
        self.assertTrue(any("coefficient" in stop.get("friction", {}) for stop in stops))
        self.assertTrue(any(stop["restitution"] == 1 for stop in stops))
        self.assertTrue(any(cell["solver"]["method"] == "adaptive" for cell in cells))
        slow = [cell for cell in cells
                if cell["sweep"]["speed_hz"] < 0.02 * cell["rotor"]["natural_frequency_hz"]]
        self.assertGreater(len(slow), 20)

    def test_some_cells_are_put_on_kits_and_all_others_stay(self):
        kinds = []
        for number in range(200):
            cell, plain = with_kits(1, number), random_cell(1, number)
            kinds.append(cell["rotor"]["kind"])
            if kinds[-1] == "jeffcott":
                self.assertEqual(cell, plain)
            else:
                length_m = cell["rotor"]["shaft"][0]["length_m"]
                for stop in cell["stops"]:
                    self.assertTrue(0 < stop["position_m"] < length_m)
        self.assertTrue(3 < kinds.count("rotor_kit") < 30)

    def test_contact_surfaces_are_wider_than_clearances(self):
        for number in range(200):
            for stop in random_cell(1, number)["stops"]:
                self.assertTrue(stop["contact_radius_m"] == 0 or stop["contact_radius_m"] > stop["clearance_m"])

    def test_the_text_holds_the_cell(self):
        cell = random_cell(1, 2)
        read = json.loads(text_of(cell))
        self.assertEqual(read.pop("output"), {"directory": "map"})
        self.assertEqual(read, cell)


if __name__ == "__main__":
    unittest.main()
