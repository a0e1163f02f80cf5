import unittest

import figures
from files import FileTest
from rubplot import csv_table
from rubplot.pictures import threshold

HEADER = "speed_hz,whirl_ratio,threshold\n"


class ThresholdMap(FileTest):
    def cells(self, rows, *arguments):
        return threshold.read_cells(self.write("map.csv", HEADER + rows), "speed_hz", "whirl_ratio", *arguments)

    def test_cells_are_over_the_natural_frequency(self):
        self.assertEqual(self.cells("60,0.2,33\n90,0.2,\n", 30), [(2, 0.2, 33), (3, 0.2, None)])

    def test_a_map_without_any_threshold_is_no_picture(self):
        with self.assertRaises(csv_table.TableError):
            self.cells("60,0.2,\n")

    def test_grid_has_a_block_for_each_speed(self):
        cells = self.cells("60,0.2,33\n60,0.4,30\n90,0.2,\n90,0.4,25\n")
        self.assertEqual(
            list(threshold.grid_lines(cells)),
            ["60 0.20000000000000001 33", "60 0.40000000000000002 30", ""]
            + ["90 0.20000000000000001 NaN", "90 0.40000000000000002 25", ""],
        )
        self.assertEqual(next(threshold.box_lines(cells)).split()[:4], ["60", "0.20000000000000001", "45", "75"])

    def test_levels_lie_between_the_thresholds(self):
        self.assertEqual(threshold.levels(self.cells("60,0.2,33\n90,0.2,450\n")), [50, 100, 200])


class Drawn(figures.FigureTest):
    def test_a_logarithmic_axis_of_the_sweep_is_one_of_the_picture(self):
        for scale, ratio in (("log", 1), ("linear", 10)):
            with self.subTest(scale=scale):
                self.write("config.yaml", "study:\n  key: kick.force_n\nsweep:\n  speed_hz:\n    values: [60, 90]\n  whirl_ratio:\n"
                           f"    from: 0.01\n    to: 1\n    count: 3\n    scale: {scale}\n")
                self.write("map.csv", HEADER + "".join(
                    f"{hz},{share},{20 * hz * share}\n" for share in (0.01, 0.1, 1) for hz in (60, 90)))
                root = self.draw("threshold")
                self.assertEqual(figures.over_each_other(root), [])
                self.assertIn("whirl ratio (quiet whirl / clearance)", figures.words(root))
                self.assertIn("shaft speed (Hz)", figures.words(root))
                self.assertIn("kick.force_n, smallest after which rub goes on", figures.words(root))
                places = {text.text: text.y for text in figures.texts(root)}
                self.assertEqual("0.1" in places and "0.01" in places, scale == "log")

    def test_of_keys_that_are_tied_together_the_first_one_names_the_threshold(self):
        self.write("config.yaml", "study:\n  keys: [kick.force_n, kick.duration_s]\n  factors: [1, 2.5e-5]\nsweep:\n"
                   "  speed_hz:\n    values: [60, 90]\n  whirl_ratio:\n    values: [0.1, 0.2]\n")
        self.write("map.csv", HEADER + "60,0.1,20\n90,0.1,30\n60,0.2,40\n90,0.2,60\n")
        self.assertIn("kick.force_n, smallest after which rub goes on", figures.words(self.draw("threshold")))


if __name__ == "__main__":
    unittest.main()
