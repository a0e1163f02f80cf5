import importlib.util
import unittest

if importlib.util.find_spec("numpy"):  # Debian: python3-numpy
    import numpy as np

    import independent_recordings as recordings
    from independent_rotor import Rotors


def drawn(causes, run_up=False, **numbers):
    """Runs of these causes at twice the first natural frequency of 30 Hz, without wandering speed or kick."""
    random = np.random.default_rng(3)
    machines = recordings.draw_machines(random)
    machines["frequency_hz"][:], machines["speed_ratio"][:], machines["unequal"][:] = 30, 2, 0
    p = recordings.draw(random, machines, np.zeros(len(causes), int), causes, False, run_up)
    p["wander"][:] = 0
    p["kick"] = np.zeros(len(causes))
    for name, value in numbers.items():
        p[name] = np.full_like(p[name], value)
    return p, random


@unittest.skipUnless(importlib.util.find_spec("numpy"), "there is no NumPy")
class IndependentRotor(unittest.TestCase):
    def test_unbalance_is_answered_as_in_closed_form(self):
        p, random = drawn(["no_rub", "run_out"])
        seen, angles, deepest, _ = Rotors(p, random).run(3, 1, 64)
        w, natural = 2 * np.pi * p["speed_hz"], p["angular"]
        gain = w**2 / (natural**2 - w**2 + 2j * p["damping"] * natural * w)
        whirl = (p["at_probe"] * p["unbalance"] * gain).sum(0)
        error = np.abs(seen - whirl[:, None] * np.exp(1j * angles)).max(1) / np.abs(whirl)
        self.assertLess(error.max(), 1e-4)
        self.assertEqual(deepest.max(), 0)

    def test_a_run_up_turns_and_whirls_as_its_speed_says(self):
        turns = 4
        p, random = drawn(["no_rub"] * 8, run_up=True)
        seen, angles, _, _ = Rotors(p, random).run(1, turns, 64)
        first, last = p["speeds"]
        self.assertEqual(set(first), {recordings.SLOWEST, recordings.FASTEST})
        # It begins with the whirl of the first speed, and turns by the mean of both.
        w, natural = 2 * np.pi * p["speed_hz"] * first, p["angular"]
        gain = w**2 / (natural**2 - w**2 + 2j * p["damping"] * natural * w)
        whirl = (p["at_probe"] * p["unbalance"] * gain).sum(0) * np.exp(1j * angles[:, 0])
        self.assertLess((np.abs(seen[:, 0] - whirl) / np.abs(whirl)).max(), 1e-4)
        recorded = turns - 64 / 1024
        expected = recorded * (first + (last - first) * recorded / turns / 2)
        self.assertLess(np.abs((angles[:, -1] - angles[:, 0]) / (2 * np.pi) / expected - 1).max(), 1e-3)

    def test_a_rub_without_losses_keeps_its_energy(self):
        # One mode: without the second one in stop and probe, the place of the probe is that mode.
        p, random = drawn(["annular"], damping=0, loss=0, friction=0, unbalance=0, offset=0)
        for place in ("at_stop", "at_probe"):
            p[place][1] = 0
        p["rigid"][:] = True
        p["kick"] = 3 * p["angular"][0]
        seen, _, deepest, touched = Rotors(p, random).run(0, 2, 1)
        z, step = seen[0], 1 / p["speed_hz"] / 1024
        velocity = (z[2:] - z[:-2]) / (2 * step[0])
        energy = np.abs(velocity) ** 2 + p["angular"][0, 0] ** 2 * np.abs(z[1:-1]) ** 2
        free = energy[np.abs(z[1:-1]) < 0.95]
        self.assertGreater(np.count_nonzero(np.abs(z) > 1), 20)
        self.assertLess(free.max() / free.min() - 1, 2e-3)
        self.assertGreater(min(deepest.max(), touched.max()), 0)

    def test_energy_off_1x_is_that_of_other_lines(self):
        angle = np.linspace(0, 20 * np.pi, 2000, endpoint=False)
        z = np.exp(1j * angle) + 0.5 * np.exp(-1j * angle) + 0.5 * np.exp(0.5j * angle)
        self.assertAlmostEqual(recordings.off_1x(z, angle), 0.25 / 1.5, places=9)

    def test_growth_at_1x_is_not_off_1x(self):
        angle = np.linspace(0, 20 * np.pi, 2000, endpoint=False)
        z = (1 + angle / 100) * np.exp(1j * angle)
        self.assertGreater(recordings.off_1x(z, angle), 1e-3)
        self.assertLess(recordings.off_1x(z, angle, growing=True), 1e-20)

    def test_what_lasts_is_off_1x_in_parts_in_a_row(self):
        angle = np.linspace(0, 720 * np.pi, 36000, endpoint=False)
        for turns, lasts in ((24, False), (72, True)):
            half = np.where(np.abs(angle / (2 * np.pi) - 180) < turns / 2, 0.5, 0)
            z = np.exp(1j * angle) + half * np.exp(0.5j * angle)
            self.assertEqual(recordings.lasting_off_1x(z, angle) > 0.03, lasts)


if __name__ == "__main__":
    unittest.main()
