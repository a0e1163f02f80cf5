import unittest

from finding import HOLDS, NOT_REPRODUCED, PARTLY
from findings_both_sides import FINDINGS
from sample_machine import SampleMachine, cell, domain, outcome_of, quiet


def locked(ratio, *speeds):
    return [cell(speed, ratio, "synchronous", 1) for speed in speeds]


def verdict(title, equal, unequal=(), traces=None):
    machine = SampleMachine(traces, both_sides=list(equal), both_sides_unequal=list(unequal))
    return outcome_of(FINDINGS, title, machine).verdict


class Synchronous(unittest.TestCase):
    def test_wide_and_wider_with_unbalance(self):
        title = "synchronous over a wide speed range"
        small = locked(0.2, 1.5) + quiet(0.2, 2, 2.5, 3)
        self.assertEqual(verdict(title, small + locked(0.6, 1.5, 2, 2.5) + quiet(0.6, 3)), HOLDS)
        self.assertEqual(verdict(title, small + locked(0.6, 1.5, 2) + quiet(0.6, 2.5, 3)), PARTLY)
        self.assertEqual(verdict(title, quiet(0.2, 2, 3) + quiet(0.6, 2, 3)), NOT_REPRODUCED)


class Orders(unittest.TestCase):
    def test_small_unbalance_only(self):
        title = "small unbalance only"
        self.assertEqual(verdict(title, domain(3, 0.5, 3.2)), HOLDS)
        self.assertEqual(verdict(title, domain(3, 0.5, 3.2, 3.3) + domain(3, 0.6, 3.2)), PARTLY)
        self.assertEqual(verdict(title, domain(3, 0.5, 3.2) + domain(3, 0.6, 3.2, 3.3)), NOT_REPRODUCED)
        self.assertEqual(verdict(title, quiet(0.5, 3.2)), NOT_REPRODUCED)

    def test_only_odd_but_for_what_a_figure_hides(self):
        title = "only odd orders"
        odd = domain(3, 0.2, *(3 + k / 100 for k in range(49)))
        self.assertEqual(verdict(title, odd + domain(2, 0.2, 2.1)), HOLDS)
        self.assertEqual(verdict(title, odd + domain(2, 0.2, 2.1, 2.2, 2.3)), PARTLY)
        self.assertEqual(verdict(title, odd[:8] + domain(2, 0.2, 2.1)), NOT_REPRODUCED)
        self.assertEqual(verdict(title, domain(5, 0.2, 5.1)), NOT_REPRODUCED)

    def test_even_orders_return(self):
        title = "even orders with unequal casings"
        odd, even = domain(3, 0.2, *(3 + k / 100 for k in range(16))), domain(2, 0.2, 2.1, 2.2, 2.3, 2.4)
        self.assertEqual(verdict(title, odd, odd + even), HOLDS)
        self.assertEqual(verdict(title, odd + even[:3], odd + even), PARTLY)
        self.assertEqual(verdict(title, odd + even, odd + even), NOT_REPRODUCED)


class OneSide(unittest.TestCase):
    def test_one_cell_is_enough(self):
        def touching(*gaps):
            return lambda role, one: [gaps, (1e-3, 1e-3)]

        title, cells = "contact on one side", domain(2, 0.2, 2.1, 2.2)
        self.assertEqual(verdict(title, [], cells, touching(-1e-6, 1e-3)), HOLDS)
        self.assertEqual(verdict(title, [], cells, touching(-1e-6, -1e-6)), NOT_REPRODUCED)
        self.assertEqual(verdict(title, [], cells, touching(1e-6, 1e-6)), NOT_REPRODUCED)

    def test_motions_of_one_hit_are_looked_at_first(self):
        asked = []

        def touching(role, one):
            asked.append(one.order)
            return [(1e-3, -1e-6)]

        several = [cell(2.3, 0.2, "subharmonic", 4, 2.0)]
        self.assertEqual(verdict("contact on one side", [], several + domain(2, 0.2, 2.1), touching), HOLDS)
        self.assertEqual(asked, [2, 4, 2])
