import unittest

import domain_measures
from domain_measures import Areas
from sample_machine import cell, circle, domain, oval, quiet

# Tongues whose answers are known by hand: an island of 1/2 at 3.6 natural frequencies in the upper row.
TONGUES = (
    domain(2, 0.2, 2.2) + quiet(0.2, 2.3, 2.4, 2.5) + domain(3, 0.2, 3.3)
    + domain(2, 0.8, 2.5, 2.6) + quiet(0.8, 3.0) + [cell(3.6, 0.8, "subharmonic", 2, 2.0)] + domain(3, 0.8, 3.7)
)


def of_order(n):
    return [cell for cell in TONGUES if cell.subharmonic(n)]


class Domains(unittest.TestCase):
    def test_where_they_begin(self):
        self.assertEqual(domain_measures.lowest_speed(of_order(2)), 2.2)
        self.assertEqual(domain_measures.highest_speed(of_order(3)), 3.7)
        self.assertEqual(domain_measures.least_ratio(of_order(2)), 0.2)
        self.assertIsNone(domain_measures.lowest_speed([]))

    def test_rows_reach_half_way_to_their_neighbours(self):
        heights = domain_measures.row_heights(quiet(0.1, 2) + quiet(0.2, 2, 3) + quiet(0.5, 2))
        for ratio, height in ((0.1, 0.1), (0.2, 0.2), (0.5, 0.3)):
            self.assertAlmostEqual(heights[ratio], height)
        self.assertEqual(domain_measures.row_heights(quiet(0.1, 2)), {0.1: 1.0})

    def test_shares_go_by_area(self):
        cells = quiet(0.1, 2, 3) + quiet(0.2, 2, 3) + quiet(0.5, 2, 3)
        self.assertAlmostEqual(Areas(cells).share(cells[4:]), 0.5)
        self.assertAlmostEqual(Areas(cells).share(cells[:1], cells[:4]), 1 / 6)
        self.assertEqual(Areas(cells).share([], []), 0)

    def test_how_they_lean_over_their_height(self):
        self.assertAlmostEqual(Areas(TONGUES).lean(of_order(3)), 0.4)
        self.assertIsNone(Areas(TONGUES).lean(of_order(3)[:1]))
        self.assertAlmostEqual(domain_measures.slope([(0, 1, 1), (1, 3, 2), (2, 5, 1)]), 2)
        self.assertAlmostEqual(domain_measures.slope([(0, 0, 1), (1, 1, 1), (1, 4, 2)]), 3)

    def test_one_island_does_not_move_a_median(self):
        self.assertEqual(domain_measures.medians(TONGUES[5:], 2), [2.6, 3.7])
        self.assertIsNone(domain_measures.medians(TONGUES, 3))

    def test_what_lies_between_them(self):
        self.assertEqual([cell.speed for cell in domain_measures.gap_cells(TONGUES, 2)], [2.4, 3.0])
        self.assertEqual(domain_measures.gap_cells(TONGUES, 3), [])
        self.assertAlmostEqual(Areas(TONGUES).parted_share(2), 1)
        self.assertIsNone(Areas(TONGUES).parted_share(3))

    def test_less_than_a_fifth_of_quiet_cells_is_no_gap(self):
        filled = [cell(2.3 + k / 10, 0.2, "chaotic") for k in range(5)]
        row = domain(2, 0.2, 2.2) + filled + quiet(0.2, 2.9) + domain(3, 0.2, 3.3)
        self.assertEqual(Areas(row).parted_share(2), 0)
        self.assertEqual(domain_measures.gap_cells(row, 2), [])
        self.assertEqual(Areas(row[:1] + row[2:]).parted_share(2), 1)

    def test_mean_widths(self):
        cells = [circle(1, 0.2)] + quiet(0.2, 1.5, 2) + [circle(1, 0.4), circle(1.5, 0.4)] + quiet(0.4, 2)
        areas = Areas(cells)
        self.assertAlmostEqual(areas.mean_width(lambda one: one.rubs(), lambda ratio: True), 0.75)
        self.assertAlmostEqual(areas.mean_width(lambda one: one.rubs(), lambda ratio: ratio > 0.3), 1)
        self.assertIsNone(areas.mean_width(lambda one: True, lambda ratio: ratio > 1))


class Gains(unittest.TestCase):
    """Circles to 2.5, 3 and 3.5 natural frequencies centred. With offset the row 0.6 lies at 0.45 of the centred map,
    half way between 0.3 and 0.6."""

    CENTRED = domain_measures.row_tops([circle(2.5, 0.3), circle(2, 0.3), circle(3, 0.6), circle(3.5, 0.9)])
    RATIOS = (0.3, 0.6, 0.9)

    def gains(self, cells, share, ratios=(0.6,)):
        return domain_measures.gains(domain_measures.row_tops(cells), self.CENTRED, ratios, self.RATIOS, share, 1.5)

    def test_the_same_ratio(self):
        self.assertAlmostEqual(self.gains([circle(3.2, 0.6)], 1)[0], 0.2)

    def test_between_two_rows_the_top_is_interpolated(self):
        self.assertAlmostEqual(self.gains([circle(3.2, 0.6)], 0.75)[0], 3.2 - 2.75)

    def test_a_row_without_circles_counts_from_the_lowest_speed(self):
        self.assertAlmostEqual(self.gains([], 1)[0], 1.5 - 3)

    def test_rows_without_circles_in_either_or_beyond_the_other_map_do_not_count(self):
        self.assertEqual(domain_measures.gains({}, {}, [0.3], [0.3], 1, 1.5), [])
        self.assertEqual(self.gains([circle(3, 0.3)], 0.75, (0.3,)), [])


class HitsPerWhirl(unittest.TestCase):
    def test_by_the_whirls_own_line(self):
        self.assertAlmostEqual(domain_measures.hits_per_whirl(oval(5, 0.3, hits=0.4)), 1)

    def test_where_1x_is_the_largest_the_next_line_of_the_comb(self):
        one_x = cell(6, 0.3, "quasi_periodic", comb=0.75, hits=0.5, dominant=1.0)
        self.assertAlmostEqual(domain_measures.hits_per_whirl(one_x), 2)

    def test_a_backward_line(self):
        backward = cell(7, 0.3, "quasi_periodic", comb=0.65, hits=0.7, dominant=-0.35)
        self.assertAlmostEqual(domain_measures.hits_per_whirl(backward), 2)
