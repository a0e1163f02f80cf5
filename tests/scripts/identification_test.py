import unittest

from command import Failure
from identification import find

ROWS = [
    {"quantity": "misfit", "sensor": "0", "value": "1"},
    {"quantity": "natural_frequency_hz", "sensor": "1", "value": "29.5"},
    {"quantity": "natural_frequency_hz", "sensor": "2", "value": "31"},
]


class Find(unittest.TestCase):
    def test_the_first_sensor_with_the_quantity(self):
        self.assertEqual(find(ROWS, "natural_frequency_hz"), ("29.5", "1"))
        with self.assertRaisesRegex(Failure, "no quantity 'mass'"):
            find(ROWS, "mass")
