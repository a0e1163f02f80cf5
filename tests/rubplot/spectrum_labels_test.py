import unittest

from rubplot.spectrum_labels import line_name, named_lines


class LineName(unittest.TestCase):
    def test_multiples_of_the_period_are_fractions(self):
        for order, period, name in ((0.5, 2, "1/2X"), (-1.5, 2, "−3/2X"), (1, 2, "1X"), (4 / 6, 6, "2/3X"), (-2, 1, "−2X")):
            self.assertEqual(line_name(order, period), name)

    def test_other_lines_are_numbers(self):
        self.assertEqual(line_name(0.38759), "0.388X")
        self.assertEqual(line_name(-0.51, 2), "−0.51X")

    def test_lines_of_a_comb_take_its_places(self):
        self.assertEqual(line_name(0.390625, 0, 0.6124), "0.388X")
        self.assertEqual(line_name(-0.21875, 0, 0.6124), "−0.225X")


class NamedLines(unittest.TestCase):
    def test_peaks_largest_first(self):
        spectrum = [(-0.5, 0.2), (0, 0.1), (0.5, 1.0), (0.75, 0.3), (1, 0.6), (1.25, 0.01)]
        self.assertEqual(named_lines(spectrum, 2), [(2, "1/2X"), (4, "1X"), (0, "−1/2X")])

    def test_small_lines_and_those_in_the_way_of_larger_ones_have_no_name(self):
        spectrum = [(0, 0), (0.1, 0.9), (0.15, 0.1), (0.2, 1.0), (0.3, 0), (1, 0.049), (2, 0), (3, 0.06)]
        self.assertEqual([i for i, _ in named_lines(spectrum, highest=3)], [3, 7])

    def test_eight_at_most(self):
        spectrum = [(k / 2, 1 + 0.01 * k if k % 2 else 0) for k in range(40)]
        self.assertEqual([i for i, _ in named_lines(spectrum, highest=20)], list(range(39, 7, -4)))

    def test_the_further_a_picture_goes_the_fewer_names_it_has_room_for(self):
        spectrum = [(k / 2, 1 if k % 2 else 0) for k in range(-16, 17)]
        counts = [len(named_lines(spectrum, highest=highest)) for highest in (2, 8)]
        orders = sorted(spectrum[i][0] for i, _ in named_lines(spectrum, highest=8))
        self.assertEqual(counts, [4, 8])
        self.assertTrue(all(b - a >= 0.78 for a, b in zip(orders, orders[1:])))
