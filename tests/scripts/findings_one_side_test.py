import unittest

from finding import HOLDS, NOT_REPRODUCED, PARTLY
from findings_one_side import FINDINGS, gap_cells
from map_cells import MapCell
from sample_machine import SampleMachine, cell, domain, outcome_of, quiet

# Domains that begin above n, lean, and part in every row; larger orders from smaller unbalance.
RATIOS = (0.1, 0.2, 0.3, 0.4)
GOOD = [
    one
    for n, first in ((2, 0.4), (3, 0.3), (4, 0.2), (5, 0.1))
    for ratio in RATIOS
    for one in (domain(n, ratio, n + 0.1 + ratio) if ratio >= first else []) + quiet(ratio, n + 0.7)
]
ISLAND = [cell(1.6, 0.4, "subharmonic", 3, 2.0)]  # a 1/3 motion of several hits


def verdict(title, cells, traces=None):
    return outcome_of(FINDINGS, title, SampleMachine(traces, one_side=cells)).verdict


class Domains(unittest.TestCase):
    def test_start(self):
        self.assertEqual(verdict("1/3 starts", GOOD), HOLDS)
        self.assertEqual(verdict("1/3 starts", GOOD + ISLAND), PARTLY)
        self.assertEqual(verdict("1/3 starts", domain(3, 0.1, 2.9)), NOT_REPRODUCED)
        self.assertEqual(verdict("1/3 starts", []), NOT_REPRODUCED)

    def test_the_number_without_filter_stands_beside_the_filtered_one(self):
        outcome = outcome_of(FINDINGS, "1/3 starts", SampleMachine(one_side=GOOD + ISLAND))
        self.assertEqual((outcome.measured, outcome.unfiltered), ("3.40", "1.60"))

    def test_lean(self):
        self.assertEqual(verdict("1/3 moves up", GOOD), HOLDS)
        self.assertEqual(verdict("1/3 moves up", GOOD + 5 * ISLAND), PARTLY)
        self.assertEqual(verdict("1/3 moves up", domain(3, 0.1, 3.5) + domain(3, 0.2, 3.4)), NOT_REPRODUCED)

    def test_unbalance_of_the_orders(self):
        title = "larger n from smaller unbalance"
        self.assertEqual(verdict(title, GOOD), HOLDS)
        self.assertEqual(verdict(title, GOOD + domain(4, 0.1, 4.2)), PARTLY)
        self.assertEqual(verdict(title, GOOD + domain(2, 0.1, 2.2)), NOT_REPRODUCED)

    def test_gaps(self):
        title = "gaps between"
        self.assertEqual(verdict(title, GOOD), HOLDS)
        islands = [cell(n + 0.9, ratio, "subharmonic", n, 3.0) for n in (2, 3, 4) for ratio in RATIOS]
        self.assertEqual(verdict(title, GOOD + islands), PARTLY)
        self.assertEqual(verdict(title, [one for one in GOOD if one.name == "subharmonic"]), NOT_REPRODUCED)

    def test_the_middle_cells_of_the_gaps(self):
        row = domain(2, 0.1, 2.2) + quiet(0.1, 2.3, 2.4, 2.5, 2.6) + domain(3, 0.1, 3.3)
        found = gap_cells(SampleMachine(one_side=row), MapCell.own_domain)
        self.assertEqual([one.speed for one in found], [2.4])


def trace(*casing_mm):
    """One approach to a wall at 1 mm for each displacement of the casing, which moves out (in, where negative)."""

    def samples(role, one):
        found, time = [(0.0, 0.0, 0.0, 1e-3), (0.01, 0.0, 0.0, 1e-3)], 0.02
        for displacement in casing_mm:
            before = 1e-3 * displacement - (1e-4 if displacement > 0 else -1e-4)
            found += [(time, 0.0, before, 1e-3), (time + 0.001, 0.9e-3, 1e-3 * displacement, -1e-5)]
            time += 0.002
        return found + [(time, 0.0, 0.0, 1e-3), (time + 0.01, 0.0, 0.0, 1e-3)]

    return samples


class Casing(unittest.TestCase):
    AWAY, MOVING = "casing a clearance away", "casing moving away"

    def test_a_clearance_away(self):
        self.assertEqual(verdict(self.AWAY, GOOD, trace(1.2, 1.5)), HOLDS)
        self.assertEqual(verdict(self.AWAY, GOOD, trace(1.2, 1.5, 0.9)), PARTLY)
        self.assertEqual(verdict(self.AWAY, GOOD, trace(0.9)), NOT_REPRODUCED)

    def test_moving_away_half_of_them_is_chance(self):
        self.assertEqual(verdict(self.MOVING, GOOD, trace(0.1, 0.2)), HOLDS)
        self.assertEqual(verdict(self.MOVING, GOOD, trace(0.1, 0.2, 0.2, 0.2, -0.1)), PARTLY)
        self.assertEqual(verdict(self.MOVING, GOOD, trace(0.1, 0.2, -0.1)), NOT_REPRODUCED)

    def test_without_domains_of_one_hit_the_unfiltered_gaps_decide(self):
        several = [cell(one.speed, one.ratio, one.name, one.order, 3.0) for one in GOOD]
        outcome = outcome_of(FINDINGS, self.AWAY, SampleMachine(trace(1.2), one_side=several))
        self.assertEqual(outcome.measured, "0 of 0 approaches in 0 cells, farthest - clearances")
        self.assertEqual(outcome.verdict, HOLDS)
