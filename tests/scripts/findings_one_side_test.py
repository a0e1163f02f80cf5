import unittest

from finding import HOLDS, NOT_REPRODUCED, PARTLY
from findings_one_side import FINDINGS
from sample_machine import SampleMachine, cell, domain, outcome_of, quiet

# Domains that begin above n, lean, and part in every row; larger orders from smaller unbalance.
RATIOS = (0.1, 0.2, 0.3, 0.4)
GOOD = [
    one
    for n, first in ((2, 0.4), (3, 0.3), (4, 0.2), (5, 0.1))
    for ratio in RATIOS
    for one in (domain(n, ratio, n + 0.1 + ratio) if ratio >= first else []) + quiet(ratio, n + 0.7)
]
ISLAND = [cell(1.6, 0.4, "subharmonic", 4, 2.0)]  # a doubled 1/2


def verdict(title, cells, traces=None):
    return outcome_of(FINDINGS, title, SampleMachine(traces, one_side=cells)).verdict


class Domains(unittest.TestCase):
    def test_nine_tenths_of_an_order_above_n(self):
        above = domain(4, 0.1, *(4.1 + k / 10 for k in range(9)))
        self.assertEqual(verdict("1/4 above", above + domain(4, 0.1, 3.9)), HOLDS)
        self.assertEqual(verdict("1/4 above", above[:4] + domain(4, 0.1, 3.9)), PARTLY)
        self.assertEqual(verdict("1/4 above", above[:1] + domain(4, 0.1, 3.8, 3.9)), NOT_REPRODUCED)
        self.assertEqual(verdict("1/4 above", []), NOT_REPRODUCED)

    def test_a_domain_that_no_eye_sees_holds_partly(self):
        empty = quiet(0.1, *(5 + k / 100 for k in range(300)))
        self.assertEqual(verdict("1/4 above", domain(4, 0.1, 4.1, 4.2) + empty), PARTLY)
        self.assertEqual(verdict("1/4 above", domain(4, 0.1, 4.1, 4.2, 4.3) + empty), HOLDS)
        self.assertEqual(verdict("1/4 above", domain(4, 0.1, 4.1, 3.9) + empty), NOT_REPRODUCED)

    def test_a_lean_of_a_column_over_the_height(self):
        def leaning(by):
            return domain(3, 0.1, 3.5) + domain(3, 0.5, 3.5 + by)

        title = "1/3 moves up"
        self.assertEqual(verdict(title, leaning(0.11)), HOLDS)
        self.assertEqual(verdict(title, leaning(0.09)), PARTLY)
        self.assertEqual(verdict(title, leaning(-0.01)), NOT_REPRODUCED)
        self.assertEqual(verdict(title, domain(3, 0.1, 3.5)), NOT_REPRODUCED)

    def test_unbalance_of_the_orders(self):
        def feet(*ratios):
            return [one for n, ratio in enumerate(ratios, 2) for one in domain(n, ratio, n + 0.1)]

        title = "larger n from smaller unbalance"
        self.assertEqual(verdict(title, feet(0.12, 0.07, 0.06, 0.05)), HOLDS)
        self.assertEqual(verdict(title, feet(0.12, 0.07, 0.06, 0.06)), PARTLY)
        self.assertEqual(verdict(title, feet(0.12, 0.07, 0.06, 0.07)), PARTLY)
        self.assertEqual(verdict(title, feet(0.12, 0.07, 0.06, 0.08)), NOT_REPRODUCED)
        self.assertEqual(verdict(title, feet(0.12, 0.12, 0.12, 0.12)), NOT_REPRODUCED)
        self.assertEqual(verdict(title, feet(0.12, 0.07, 0.06)), NOT_REPRODUCED)

    def test_motions_of_figure_7(self):
        title = "figure 7"
        row = [one for n in (2, 3, 4) for one in domain(n, 0.1, n + 0.1)]
        self.assertEqual(verdict(title, row), HOLDS)
        self.assertEqual(verdict(title, row[1:] + domain(2, 0.12, 2.1)), HOLDS)
        self.assertEqual(verdict(title, row[1:]), PARTLY)
        self.assertEqual(verdict(title, row[2:] + domain(2, 0.13, 2.1) + domain(3, 0.07, 3.1)), NOT_REPRODUCED)

    def test_gaps(self):
        title = "gaps between"
        rows = [one for ratio in (0.1, 0.2, 0.3) for n in (2, 3, 4, 5) for one in domain(n, ratio, n + 0.1)]
        calm = {ratio: quiet(ratio, 2.5, 3.5, 4.5) for ratio in (0.1, 0.2, 0.3)}
        self.assertEqual(verdict(title, rows + calm[0.1] + calm[0.2] + calm[0.3]), HOLDS)
        self.assertEqual(verdict(title, rows + calm[0.1] + calm[0.2] + calm[0.3][:2]), PARTLY)
        self.assertEqual(verdict(title, rows + calm[0.1]), NOT_REPRODUCED)
        self.assertEqual(verdict(title, domain(2, 0.1, 2.1)), NOT_REPRODUCED)

    def test_how_far_the_rotor_is_thrown(self):
        def thrown(*distances):
            return [cell(3 + k, 0.1, "chaotic", farthest=d) for k, d in enumerate(distances)] + quiet(0.1, 2)

        title = "the rotor stays near"
        self.assertEqual(verdict(title, thrown(2, 3, 4, 5, 6)), HOLDS)
        self.assertEqual(verdict(title, thrown(2, 3, 4, 6, 6)), PARTLY)
        self.assertEqual(verdict(title, thrown(2, 6, 6)), NOT_REPRODUCED)
        self.assertEqual(verdict(title, thrown(2, 3, 4, 5, 11)), NOT_REPRODUCED)


def trace(displacement, moved):
    """A hit, then a miss of a wall at 1 mm whose casing is so many clearances away and has moved by `moved`."""

    def samples(role, one):
        before, now = 1e-3 * (displacement - moved), 1e-3 * displacement
        return [
            (0.0, 0.0, 0.0, 1e-3), (0.01, 0.0, 0.0, 1e-3), (0.02, 0.9e-3, 0.0, -1e-5), (0.03, 0.0, before, 1e-3),
            (0.04, 0.9e-3, now, 1e-4), (0.05, 0.0, 0.0, 1e-3), (0.06, 0.0, 0.0, 1e-3),
        ]

    return samples


class Casing(unittest.TestCase):
    ROW = [one for n in (2, 3) for one in domain(n, 0.1, n + 0.1) + quiet(0.1, n + 0.7)]
    AWAY, MOVING = "casing a clearance away", "casing outside of its place"

    def test_a_clearance_away(self):
        self.assertEqual(verdict(self.AWAY, self.ROW, trace(1.2, 0.1)), HOLDS)
        self.assertEqual(verdict(self.AWAY, self.ROW, trace(0.9, 0.1)), NOT_REPRODUCED)
        self.assertEqual(verdict(self.AWAY, [], trace(1.2, 0.1)), NOT_REPRODUCED)

    def test_a_share_of_the_gaps(self):
        def two_of_three(role, one):
            return trace(1.2 if one.ratio < 0.3 else 0.9, 0.1)(role, one)

        rows = [one for ratio in (0.1, 0.2, 0.3) for one in domain(2, ratio, 2.1) + quiet(ratio, 2.5) + domain(3, ratio, 3.1)]
        self.assertEqual(verdict(self.AWAY, rows, two_of_three), PARTLY)

    def test_a_casing_at_rest_moves_nowhere(self):
        self.assertEqual(verdict(self.MOVING, self.ROW, trace(0.2, 0.1)), HOLDS)
        self.assertEqual(verdict(self.MOVING, self.ROW, trace(0.2, -0.1)), NOT_REPRODUCED)
        self.assertEqual(verdict(self.MOVING, self.ROW, trace(0.9e-3, 0.1e-3)), NOT_REPRODUCED)
        machine = SampleMachine(trace(0.9e-3, 0.1e-3), one_side=self.ROW)
        self.assertEqual(outcome_of(FINDINGS, self.MOVING, machine).measured, "0 of 1 approaches, in 1 it is at rest")


class Sample(unittest.TestCase):
    def test_a_good_map_holds_throughout(self):
        for title in ("1/2 above", "1/5 above", "1/5 moves up", "larger n", "nothing but", "stays near"):
            self.assertEqual(verdict(title, GOOD), HOLDS, title)
        self.assertEqual(verdict("1/4 above", GOOD + 2 * ISLAND), PARTLY)
