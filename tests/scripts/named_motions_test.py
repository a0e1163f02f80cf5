import unittest

from finding import HOLDS, NOT_REPRODUCED, PARTLY
from named_motions import nothing_else, one_of_n, synchronous
from sample_machine import SampleMachine, cell, domain, quiet

FINDING = nothing_else("title", "one_side", (synchronous, one_of_n), "synchronous or 1/n")


def outcome(*cells):
    return FINDING.outcome(SampleMachine(one_side=list(cells)))


class NothingElse(unittest.TestCase):
    def test_shares_of_the_rub(self):
        good = domain(3, 0.2, *(3 + k / 100 for k in range(9))) + quiet(0.2, 2, 2.5)
        chaos = [cell(4 + k, 0.2, "chaotic") for k in range(10)]
        self.assertEqual(outcome(*good, chaos[0]).verdict, HOLDS)
        self.assertEqual(outcome(*good, *chaos[:2]).verdict, PARTLY)
        self.assertEqual(outcome(*good, *chaos).verdict, NOT_REPRODUCED)
        self.assertEqual(outcome(*good, chaos[0]).measured, "90 % of the rub; 10 % is chaotic or unsettled")

    def test_an_order_whose_domain_begins_beyond_the_maps_is_none_of_them(self):
        self.assertEqual(outcome(*domain(7, 0.2, 7.2)).verdict, HOLDS)
        self.assertEqual(outcome(*domain(8, 0.2, 7.2)).verdict, NOT_REPRODUCED)

    def test_a_map_without_rub_shows_nothing(self):
        self.assertEqual(outcome(*quiet(0.2, 2)).verdict, NOT_REPRODUCED)
