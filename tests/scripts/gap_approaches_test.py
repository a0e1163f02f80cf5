import unittest

from gap_approaches import Approach, approaches, decisive, until_first_miss

# A hit in the kick, which does not count; a hit on a resting casing; one on a casing 2 clearances away that moves away
# at 10 per second; a miss; and what comes after it.
SAMPLES = [
    (0.0, 0.9, 0.0, 0.1),
    (0.4, 1.5, 0.5, 0.0),
    (0.8, 0.0, 0.0, 1.0),
    (1.0, 0.9, 0.0, 0.1),
    (1.1, 1.2, 0.3, -0.1),
    (1.2, 0.0, 0.0, 1.0),
    (1.9, 0.6, 1.0, 1.4),
    (2.0, 2.9, 2.0, 0.1),
    (2.1, 3.3, 2.1, -0.2),
    (2.2, 0.0, 0.0, 1.0),
    (3.0, 0.7, 0.0, 0.3),
    (3.1, 0.8, 0.0, 0.2),
    (3.2, 0.7, 0.0, 0.3),
    (3.3, 0.0, 0.0, 1.0),
    (4.0, 0.8, 0.0, 0.2),
    (4.1, 0.0, 0.0, 1.0),
    (4.2, 0.0, 0.0, 1.0),
]


class Approaches(unittest.TestCase):
    def expect(self, found, *expected):
        self.assertEqual(len(found), len(expected))
        for approach, (hit, *figures) in zip(found, expected):
            self.assertEqual(approach.hit, hit)
            for value, figure in zip((approach.displacement, approach.velocity, approach.gap, approach.largest), figures):
                self.assertAlmostEqual(value, figure)

    HIT, FAR_HIT, MISS = (True, 0, 0, 0.1, 0.3), (True, 2, 10, 0.1, 2.1), (False, 0, 0, 0.2, 0)

    def test_every_approach_after_the_kick(self):
        self.expect(approaches(SAMPLES, 1, 0.5), self.HIT, self.FAR_HIT, self.MISS, self.MISS)

    def test_until_the_rub_is_over(self):
        self.expect(until_first_miss(approaches(SAMPLES, 1, 0.5)), self.HIT, self.FAR_HIT, self.MISS)
        misses = approaches(SAMPLES, 1, 2.5)
        self.assertEqual(len(until_first_miss(misses)), 1)

    def test_the_approach_that_decides(self):
        self.expect([decisive(approaches(SAMPLES, 1, 0.5))], self.MISS)
        self.assertIsNone(decisive(approaches(SAMPLES[:11], 1, 0.5)))
        self.assertIsNone(decisive([]))

    def test_lengths_are_in_clearances(self):
        small = [(t, *(1e-3 * x for x in rest)) for t, *rest in SAMPLES]
        self.expect(until_first_miss(approaches(small, 1e-3, 0.5)), self.HIT, self.FAR_HIT, self.MISS)

    def test_an_approach_that_the_run_ends_in_is_left_out(self):
        self.assertEqual(len(approaches(SAMPLES[:5], 1, 0.5)), 0)
        self.assertEqual(approaches([], 1, 0.5), [])
        self.assertIsInstance(approaches(SAMPLES, 1, 0.5)[0], Approach)
