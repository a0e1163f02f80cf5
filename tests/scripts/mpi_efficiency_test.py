import unittest

from mpi_efficiency import medians, report


class Medians(unittest.TestCase):
    def test_each_of_its_own(self):
        self.assertEqual(medians(["3 1 1", "1 2 2", "2 9 1"]), (2, 4))

    def test_report(self):
        self.assertEqual(
            list(report((4, 4), (2.5, 5), 2)),
            [
                "one process: 4.00 s, 4.00 s of processor time",
                "2 ranks: 2.50 s, 5.00 s of processor time",
                "efficiency: 80 % on the wall clock, 80 % in processor time",
            ],
        )
