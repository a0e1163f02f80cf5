import unittest

from finding import HOLDS, NOT_REPRODUCED, PARTLY
from findings_annulus import FINDINGS
from sample_machine import SampleMachine, cell, circle, domain, outcome_of, oval, quiet

CENTRED = [circle(1.5, 0.4), circle(2.5, 0.6), oval(4, 0.3), oval(5, 0.4)]


def outcome(title, centred=(), offset=(), traces=None):
    return outcome_of(FINDINGS, title, SampleMachine(traces, annulus=list(centred), annulus_offset=list(offset)))


def verdict(*arguments):
    return outcome(*arguments).verdict


class Centred(unittest.TestCase):
    def test_circle_at_low_speed(self):
        title = "synchronous circle at low speed"
        self.assertEqual(verdict(title, CENTRED), HOLDS)
        self.assertEqual(verdict(title, CENTRED + [circle(6, 0.6)]), PARTLY)
        self.assertEqual(verdict(title, CENTRED[2:] + [circle(6, 0.6)]), NOT_REPRODUCED)
        self.assertEqual(verdict(title, CENTRED[2:]), NOT_REPRODUCED)

    def test_a_quasi_periodic_oval_is_not_the_synchronous_one(self):
        title = "oval whirl at high speed"
        self.assertEqual(verdict(title, CENTRED), PARTLY)
        self.assertIn("0 synchronous ovals", outcome(title, CENTRED).measured)
        self.assertEqual(verdict(title, CENTRED + [cell(6, 0.3, "synchronous", 1, orbit="oval")]), HOLDS)
        self.assertEqual(verdict(title, CENTRED[:2]), NOT_REPRODUCED)
        self.assertEqual(verdict(title, CENTRED + [circle(6, 0.6)]), NOT_REPRODUCED)

    def test_unbalance(self):
        title = "from smaller unbalance"
        self.assertEqual(verdict(title, CENTRED), HOLDS)
        self.assertEqual(verdict(title, CENTRED + [circle(1.5, 0.2)]), NOT_REPRODUCED)

    def test_hits_per_whirl(self):
        title = "hits several times"
        self.assertEqual(verdict(title, [oval(5, 0.3, hits=0.8)]), HOLDS)
        self.assertEqual(verdict(title, [oval(5, 0.3, hits=0.8), oval(5, 0.4, hits=0.8), oval(5, 0.5, hits=0.4)]), PARTLY)
        self.assertEqual(verdict(title, [oval(5, 0.3, hits=0.4)]), NOT_REPRODUCED)

    def test_shape(self):
        def spectrum(backward):
            empty = [(order / 10, 0.0) for order in range(-3, 4)]
            return lambda role, one: [(-0.4, backward)] + empty + [(0.45, 3.0), (1, 9.0)]

        title = "the whirl is an oval"
        self.assertEqual(verdict(title, CENTRED, (), spectrum(1.0)), HOLDS)
        self.assertEqual(verdict(title, CENTRED, (), spectrum(0.1)), NOT_REPRODUCED)
        round_one = outcome(title, CENTRED, (), spectrum(0.1))
        self.assertEqual(round_one.measured, "0 of 2 sampled cells, none")
        self.assertIn("axes 0.94 to 0.94 : 1, turning by up to 0.0", round_one.unfiltered)


class Offset(unittest.TestCase):
    def test_circle_to_higher_speed_at_the_same_ratio(self):
        title = "same whirl ratio"
        self.assertEqual(verdict(title, [circle(2, 0.4)], [circle(2.5, 0.4)]), HOLDS)
        self.assertEqual(verdict(title, [circle(2, 0.4)], [circle(2, 0.4)]), NOT_REPRODUCED)

    def test_circle_to_higher_speed_at_the_same_unbalance(self):
        # 0.75 x 0.4 lies at 0.3 of the centred map.
        title = "same unbalance"
        centred = [circle(2, 0.3), circle(3, 0.4)]
        self.assertEqual(verdict(title, centred, [circle(2.5, 0.4)]), HOLDS)
        self.assertEqual(verdict(title, centred, [circle(2, 0.4)]), NOT_REPRODUCED)

    def test_subharmonics_slightly_above_n(self):
        title = "subharmonics slightly above n"
        good = domain(2, 0.3, 2.1) + domain(3, 0.3, 3.2)
        self.assertEqual(verdict(title, (), good), HOLDS)
        self.assertEqual(verdict(title, (), good + domain(2, 0.3, 3.4)), PARTLY)
        self.assertEqual(verdict(title, (), domain(2, 0.3, 2.1)), NOT_REPRODUCED)
        self.assertEqual(verdict(title, (), good + domain(2, 0.3, 1.9)), NOT_REPRODUCED)

    def test_another_kind_of_circle(self):
        title = "another kind of synchronous circle"
        small = circle(8, 0.5, amplitude_m=5e-4)
        self.assertEqual(verdict(title, CENTRED, [small]), HOLDS)
        self.assertEqual(verdict(title, CENTRED + [small], [small]), PARTLY)
        self.assertEqual(verdict(title, CENTRED, [circle(2, 0.5)] + quiet(0.5, 3)), NOT_REPRODUCED)
