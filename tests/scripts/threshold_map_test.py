import unittest

import csv_table
import threshold_map
from files import FileTest

HEADER = "speed_hz,whirl_ratio,threshold\n"


class ThresholdMap(FileTest):
    def cells(self, rows, *arguments):
        return threshold_map.read_cells(self.write("map.csv", HEADER + rows), "speed_hz", "whirl_ratio", *arguments)

    def test_cells_are_over_the_natural_frequency(self):
        self.assertEqual(self.cells("60,0.2,33\n90,0.2,\n", 30), [(2, 0.2, 33), (3, 0.2, None)])

    def test_a_map_without_any_threshold_is_no_picture(self):
        with self.assertRaises(csv_table.TableError):
            self.cells("60,0.2,\n")

    def test_grid_has_a_block_for_each_speed(self):
        cells = self.cells("60,0.2,33\n60,0.4,30\n90,0.2,\n90,0.4,25\n")
        self.assertEqual(
            list(threshold_map.grid_lines(cells)),
            ["60 0.20000000000000001 33", "60 0.40000000000000002 30", ""]
            + ["90 0.20000000000000001 NaN", "90 0.40000000000000002 25", ""],
        )
        self.assertEqual(next(threshold_map.box_lines(cells)).split()[:4], ["60", "0.20000000000000001", "45", "75"])

    def test_levels_lie_between_the_thresholds(self):
        self.assertEqual(threshold_map.levels(self.cells("60,0.2,33\n90,0.2,450\n")), [50, 100, 200])


if __name__ == "__main__":
    unittest.main()
