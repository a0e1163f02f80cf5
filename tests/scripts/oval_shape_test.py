import unittest

from oval_shape import ellipse

# An ellipse of half-axes 4 and 2 that turns by 0.05 per revolution, with a fifth line of energy 1 in 11 off it.
SPECTRUM = [(-0.45, 1), (-0.25, 0), (-0.2, 0), (-0.1, 0), (0, 7), (0.1, 0), (0.2, 0), (0.3, 0), (0.55, 3), (0.6, 0),
            (0.7, 0), (0.8, 0), (1, 9), (2, 1)]


class Ellipse(unittest.TestCase):
    def test_its_axes_turning_and_share(self):
        found = ellipse(SPECTRUM)
        self.assertAlmostEqual(found.axes, 0.5)
        self.assertAlmostEqual(found.precession, 0.05)
        self.assertAlmostEqual(found.energy_share, 10 / 11)
        self.assertTrue(found.nearly_closed_oval())

    def test_a_line_between_bins_is_taken_whole(self):
        split = [(order, 3 / 2**0.5) if order in (0.55, 0.6) else (order, amplitude) for order, amplitude in SPECTRUM]
        self.assertAlmostEqual(ellipse(split).axes, 0.5)

    def test_one_side_alone_is_no_ellipse(self):
        self.assertIsNone(ellipse([(order, amplitude) for order, amplitude in SPECTRUM if order >= 0]))
        self.assertIsNone(ellipse([(-1, 0.0), (0, 1), (0.5, 2)]))

    def test_what_turns_fast_is_not_seen_as_an_oval(self):
        fast = [(order + 0.1 if order == 0.55 else order, amplitude) for order, amplitude in SPECTRUM]
        self.assertFalse(ellipse(fast).nearly_closed_oval())
