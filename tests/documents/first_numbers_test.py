"""first_numbers_test.py TOP: restitutions of docs/guide/numbers.md are those of the formula beside them, and the swing of
its kick is that of an oscillator which is solved step by step."""

import math
import os
import re
import sys
import unittest

TOP = sys.argv[1]


def rows(text, head):
    """Cells of the table whose first cell of the head is this."""
    lines = text.split(f"| {head} |", 1)[1].split("\n")[2:]
    for line in lines:
        if not line.startswith("|"):
            return
        yield [cell.strip() for cell in line.strip("|").split("|")]


def restitution(yield_pa, youngs_pa, poisson, speed, mass=1, radius=0.01):
    """Johnson, Contact Mechanics, eq. 11.48, against hardened steel."""
    modulus = 1 / ((1 - 0.3**2) / 206e9 + (1 - poisson**2) / youngs_pa)
    return min(1, 3.8 * math.sqrt(yield_pa / modulus) * (mass * speed**2 / (2 * yield_pa * radius**3)) ** (-1 / 8))


def swing(force, duration, mass, hz, steps=20000):
    """Largest displacement of an undamped oscillator after a half sine, by the method of leapfrog."""
    x = v = largest = 0.0
    step = 1 / hz / steps
    for i in range(steps):
        t = i * step
        pull = force * math.sin(math.pi * t / duration) if t < duration else 0
        v += step * (pull / mass - (2 * math.pi * hz) ** 2 * x)
        x += step * v
        largest = max(largest, abs(x))
    return largest


class FirstNumbers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(os.path.join(TOP, "docs", "guide", "numbers.md"), encoding="utf-8") as file:
            cls.text = file.read()

    def test_restitution(self):
        count = 0
        for _, stress, modulus, poisson, *values in rows(self.text, "softer body"):
            for speed, value in zip((0.1, 0.3, 1.0), values):
                self.assertAlmostEqual(restitution(1e6 * float(stress), 1e9 * float(modulus), float(poisson), speed),
                                       float(value), delta=0.00501)
                count += 1
        self.assertEqual(count, 15)

    def test_kick(self):
        said = re.search(r"([\d.]+) N for ([\d.]+) ms on ([\d.]+) kg at ([\d.]+) Hz swing\s+([\d.]+) mm", self.text)
        force, milliseconds, mass, hz, millimetres = map(float, said.groups())
        self.assertAlmostEqual(1e3 * swing(force, milliseconds / 1e3, mass, hz), millimetres, delta=0.06)

    def test_friction_is_dry_friction_above_greased(self):
        for pair, dry, greased in rows(self.text, "pair"):
            if greased:
                self.assertLess(float(greased.split()[-1]), float(dry), pair)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
