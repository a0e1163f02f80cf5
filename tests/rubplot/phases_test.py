import unittest

from rubplot import phases


class Phases(unittest.TestCase):
    def test_a_phase_comes_within_half_a_turn_of_the_other(self):
        for phase in (-725.0, -2.0, 0.0, 90.0, 1234.5):
            for other in (-900.0, -179.0, 0.0, 500.0):
                moved = phases.beside(phase, other)
                self.assertLessEqual(abs(moved - other), 180)
                self.assertAlmostEqual((moved - phase) % 360 % 360, 0)

    def test_the_first_one_stays(self):
        self.assertEqual(phases.beside(725.0, None), 725.0)
