import math
import unittest

from run_up_by_amplitude import amplitudes, least, left_um


class Amplitudes(unittest.TestCase):
    def test_a_slow_ramp_has_the_amplitudes_of_steady_speeds(self):
        speeds = [20.0, 24.0, 27.0]
        for speed, found in zip(speeds, amplitudes(speeds, 30.0, 0.05, 0.5)):
            r = speed / 30
            self.assertAlmostEqual(found / (r * r / math.hypot(1 - r * r, 0.1 * r)), 1, delta=0.02)

    def test_a_ramp_moves_the_largest_behind_the_resonance(self):
        speeds = [25 + 0.25 * k for k in range(40)]
        found = amplitudes(speeds, 30.0, 0.01, 4.0)
        self.assertGreater(speeds[found.index(max(found))], 30.5)


class Least(unittest.TestCase):
    def test_the_numbers_of_a_mode_come_back(self):
        speeds = [26 + 0.4 * k for k in range(16)]
        measured = [3 * value for value in amplitudes(speeds, 29.0, 0.02, 4.0)]
        left, found = least(lambda numbers: left_um(speeds, measured, [*numbers, 4.0]), [28.6, 0.015], [0.2, 0.004])
        self.assertAlmostEqual(found[0], 29.0, delta=0.02)
        self.assertAlmostEqual(found[1], 0.02, delta=0.001)
        self.assertLess(left, 0.3)
