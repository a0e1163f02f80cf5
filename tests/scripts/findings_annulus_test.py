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

    def test_without_ovals_low_is_the_lower_half_of_the_map(self):
        self.assertEqual(verdict("circle at low speed", [circle(1.5, 0.4)] + quiet(0.4, 3, 4)), HOLDS)
        self.assertEqual(verdict("circle at low speed", [circle(4, 0.4)] + quiet(0.4, 2, 3)), NOT_REPRODUCED)

    def test_a_quasi_periodic_oval_is_not_the_synchronous_one(self):
        title = "synchronous oval at high speed"
        locked = [cell(speed, 0.4, "synchronous", 1, orbit="oval", backward_m=1e-3) for speed in (6, 7)]
        self.assertEqual(verdict(title, CENTRED), PARTLY)
        self.assertIn("0 synchronous of 2 ovals", outcome(title, CENTRED).measured)
        self.assertEqual(verdict(title, CENTRED + locked[:1]), PARTLY)
        self.assertEqual(verdict(title, CENTRED + locked), HOLDS)
        self.assertEqual(verdict(title, CENTRED[:2]), NOT_REPRODUCED)
        self.assertEqual(verdict(title, CENTRED + 3 * [circle(6, 0.6)]), NOT_REPRODUCED)

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
        self.assertEqual(round_one.measured, "0 of 2 cells, turning by 0.02 per revolution in the median")
        self.assertTrue(outcome(title, CENTRED, (), spectrum(1.0)).measured.endswith("axes 0.50 to 0.50 : 1"))
        self.assertEqual(verdict(title, CENTRED[:2]), NOT_REPRODUCED)

    def test_nothing_else(self):
        title = "nothing but circle and oval"
        self.assertEqual(verdict(title, CENTRED), HOLDS)
        self.assertEqual(verdict(title, CENTRED + [cell(3, 0.4, "chaotic")]), PARTLY)


class Offset(unittest.TestCase):
    def test_circle_to_higher_speed_at_the_same_unbalance(self):
        # 0.75 x 0.4 lies at 0.3 of the centred map; the columns are half a natural frequency.
        title = "circle to higher speed"
        centred = [circle(2, 0.3), circle(3, 0.4)] + quiet(0.3, 1.5)
        calm = quiet(0.4, 1.5, 2, 2.5)
        self.assertEqual(verdict(title, centred, [circle(2.5, 0.4)] + calm), HOLDS)
        self.assertEqual(verdict(title, centred, [circle(2.1, 0.4)] + calm), PARTLY)
        self.assertEqual(verdict(title, centred, [circle(2, 0.4)] + calm), NOT_REPRODUCED)
        self.assertEqual(verdict(title, quiet(0.3, 2), calm), NOT_REPRODUCED)

    def test_subharmonics_slightly_above_n(self):
        title = "subharmonics slightly above n"
        good = domain(2, 0.3, 2.1) + domain(3, 0.3, 3.2)
        self.assertEqual(verdict(title, (), good), HOLDS)
        self.assertEqual(verdict(title, (), domain(5, 0.3, 5.2, 5.3)), HOLDS)
        self.assertEqual(verdict(title, (), good + domain(2, 0.3, 2.6)), PARTLY)
        self.assertEqual(verdict(title, (), domain(2, 0.3, 2.1)), NOT_REPRODUCED)
        self.assertEqual(verdict(title, (), good + domain(2, 0.3, 1.8, 1.9, 2.0)), NOT_REPRODUCED)

    def test_another_kind_of_circle(self):
        title = "another kind of synchronous circle"
        small, free = circle(8, 0.5, amplitude_m=5e-4), circle(8, 0.5, contact=0.4)
        pressed = circle(2, 0.5)
        self.assertEqual(verdict(title, CENTRED, [small, pressed]), HOLDS)
        self.assertEqual(verdict(title, CENTRED, [free, pressed]), HOLDS)
        self.assertEqual(verdict(title, CENTRED, [free]), NOT_REPRODUCED)
        self.assertEqual(verdict(title, CENTRED + [small], [small, pressed]), PARTLY)
        self.assertEqual(verdict(title, CENTRED, [pressed] + quiet(0.5, 3)), NOT_REPRODUCED)
