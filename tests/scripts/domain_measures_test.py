import unittest

import domain_measures
from map_cells import MapCell
from sample_machine import cell, circle, domain, oval, quiet

# The same tongues whose answers are known by hand: an island of 1/2 that hits every turn at 2.1 natural frequencies.
TONGUES = (
    domain(2, 0.2, 2.2) + quiet(0.2, 2.3, 2.4, 2.5) + domain(3, 0.2, 3.3)
    + [cell(2.1, 0.8, "subharmonic", 2, 2.0)] + domain(2, 0.8, 2.6) + quiet(0.8, 3.0) + domain(3, 0.8, 3.7)
)


def of_order(n):
    return [cell for cell in TONGUES if cell.subharmonic(n)]


def own(n):
    return [cell for cell in of_order(n) if cell.own_domain()]


class Domains(unittest.TestCase):
    def test_where_they_begin(self):
        self.assertEqual(domain_measures.lowest_speed(own(2)), 2.2)
        self.assertEqual(domain_measures.lowest_speed(of_order(2)), 2.1)
        self.assertEqual(domain_measures.highest_speed(own(3)), 3.7)
        self.assertEqual(domain_measures.least_ratio(own(2)), 0.2)
        self.assertIsNone(domain_measures.lowest_speed([]))

    def test_how_they_lean(self):
        self.assertAlmostEqual(domain_measures.lean(own(2)), 0.4 / 0.6)
        self.assertIsNone(domain_measures.lean(own(2)[:1]))
        self.assertAlmostEqual(domain_measures.slope([(0, 1), (1, 3), (2, 5)]), 2)

    def test_what_lies_between_them(self):
        gaps = domain_measures.gaps(TONGUES, 2, MapCell.own_domain)
        self.assertEqual([[cell.speed for cell in row] for row in gaps], [[2.3, 2.4, 2.5], [3.0]])
        self.assertEqual(domain_measures.gaps(TONGUES, 3, MapCell.own_domain), [])

    def test_widths_row_by_row(self):
        cells = [circle(1, 0.2)] + quiet(0.2, 1.5, 2) + [circle(1, 0.4), circle(1.5, 0.4)] + quiet(0.4, 2)
        self.assertEqual(domain_measures.widths(cells, MapCell.synchronous_circle), [(0.2, 0.5), (0.4, 1.0)])


class RowsReachingHigher(unittest.TestCase):
    """Circles to 75, 90 and 105 Hz centred. With offset the row 0.6 lies at 0.45 of the centred map, between 0.3 and
    0.6."""

    CENTRED = domain_measures.row_tops([circle(2.5, 0.3), circle(3, 0.6), circle(3.5, 0.9)])
    OFFSET = domain_measures.row_tops([circle(3.2, 0.6), circle(3.5, 0.9), circle(8, 0.9)])
    RATIOS = (0.3, 0.6, 0.9)

    def compared(self, share):
        return domain_measures.rows_reaching_higher(self.OFFSET, self.CENTRED, self.RATIOS, self.RATIOS, share)

    def test_the_same_ratio(self):
        self.assertEqual(self.compared(1), (2, 3))

    def test_the_same_unbalance_must_beat_both_rows_about_it(self):
        self.assertEqual(self.compared(0.75), (2, 3))
        lower = domain_measures.row_tops([circle(2.9, 0.6)])
        self.assertEqual(
            domain_measures.rows_reaching_higher(lower, self.CENTRED, [0.6], self.RATIOS, 0.75), (0, 1)
        )

    def test_rows_without_circles_in_either_do_not_count(self):
        self.assertEqual(domain_measures.rows_reaching_higher({}, {}, [0.3], [0.3]), (0, 0))


class HitsPerWhirl(unittest.TestCase):
    def test_by_the_whirls_own_line(self):
        self.assertAlmostEqual(domain_measures.hits_per_whirl(oval(5, 0.3, hits=0.4)), 1)

    def test_where_1x_is_the_largest_the_next_line_of_the_comb(self):
        one_x = cell(6, 0.3, "quasi_periodic", comb=0.75, hits=0.5, dominant=1.0)
        self.assertAlmostEqual(domain_measures.hits_per_whirl(one_x), 2)

    def test_a_backward_line(self):
        backward = cell(7, 0.3, "quasi_periodic", comb=0.65, hits=0.7, dominant=-0.35)
        self.assertAlmostEqual(domain_measures.hits_per_whirl(backward), 2)
