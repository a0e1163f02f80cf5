import unittest

import campbell_layout


def point(mode, speed, frequency, whirl="forward"):
    return {"mode": float(mode), "speed_hz": float(speed), "frequency_hz": float(frequency), "whirl": whirl}


class Curves(unittest.TestCase):
    def test_a_stretch_ends_where_the_next_one_begins(self):
        rows = [point(1, 0, 30, "backward"), point(1, 10, 29, "mixed"), point(2, 0, 30)]
        self.assertEqual(list(campbell_layout.curve_lines(rows)),
                         ["0 30 1", "10 29 1", "", "10 29 2", "", "0 30 0", ""])


class Labels(unittest.TestCase):
    def test_modes_that_end_at_one_height_share_a_text(self):
        rows = [point(1, 0, 30), point(1, 100, 30), point(2, 0, 31), point(2, 100, 31), point(3, 0, 80), point(3, 100, 90),
                point(4, 0, 150), point(4, 100, 160)]
        names = list(campbell_layout.name_lines(rows, 150))
        self.assertEqual(len(names), 2)  # the fourth ends above the picture
        self.assertIn("'1,2' at first 100, first 30.5", names[0])
        self.assertIn("'3' at first 100, first 90", names[1])

    def test_close_speeds_get_one_label_and_near_ones_stand_on_different_sides(self):
        rows = [{"speed_hz": speed} for speed in (5, 50, 50.1, 56, 90)]
        labels = list(campbell_layout.label_lines(rows, 100))
        self.assertEqual(len(labels), 4)
        self.assertIn("'5' at first 5, first 5 left offset 0.3, 0.9", labels[0])
        self.assertIn("'50.05'", labels[1])
        self.assertIn("left offset 0.8, -0.8", labels[1])
        self.assertIn("right offset -0.8, 0.8", labels[2])
        self.assertIn("right offset -0.8, 0.8", labels[3])


class Shapes(unittest.TestCase):
    @staticmethod
    def shape(mode, whirl, x, y):
        return [{"mode": float(mode), "whirl": whirl, "frequency_hz": 30.0, "position_m": 0.1 * i,
                 "x_real": a, "x_imag": 0.0, "y_real": b, "y_imag": 0.0} for i, (a, b) in enumerate(zip(x, y))]

    def test_backward_partners_and_discs_without_a_shaft_are_left_out(self):
        rows = self.shape(1, "backward", (0, 1), (0, 0)) + self.shape(2, "forward", (0, 1), (0, 0))
        self.assertEqual([number for number, _ in campbell_layout.shown_shapes(rows)], [2])
        self.assertEqual(campbell_layout.shown_shapes(self.shape(2, "forward", (1,), (0,))), [])

    def test_the_plane_of_the_larger_deflection_is_drawn(self):
        shown = campbell_layout.shown_shapes(self.shape(1, "mixed", (0.1, 0.2), (0.5, 1)))
        lines = list(campbell_layout.shape_lines(shown))
        self.assertEqual(lines[0], '"mode 1, 30 Hz"')
        self.assertEqual([line.split()[1] for line in lines[1:3]], ["0.5", "1"])

    def test_what_stands_on_the_shaft(self):
        config = {"rotor.discs.0.position_m": "0.25", "rotor.supports.0.position_m": "0", "stops.0.position_m": "0.5"}
        self.assertEqual(list(campbell_layout.shaft_lines(config)), ["250 0", "0 1", "500 2"])
