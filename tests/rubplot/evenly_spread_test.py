import unittest

from rubplot.evenly_spread import spread


class Spread(unittest.TestCase):
    def test_many_are_thinned_and_few_are_kept(self):
        self.assertEqual(spread(list(range(10)), 5), [1, 3, 5, 7, 9])
        self.assertEqual(spread([1, 2], 5), [1, 2])
