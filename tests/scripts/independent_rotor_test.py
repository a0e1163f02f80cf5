import importlib.util
import unittest

if importlib.util.find_spec("numpy"):  # Debian: python3-numpy
    import numpy as np

    import independent_recordings as recordings
    from independent_rotor import Rotors


def drawn(causes, **numbers):
    """Runs of these causes at twice the first natural frequency of 30 Hz, without wandering speed or kick."""
    random = np.random.default_rng(3)
    machines = recordings.draw_machines(random)
    machines["frequency_hz"][:], machines["speed_ratio"][:], machines["unequal"][:] = 30, 2, 0
    p = recordings.draw(random, machines, np.zeros(len(causes), int), causes, False)
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


if __name__ == "__main__":
    unittest.main()
