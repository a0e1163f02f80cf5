import contextlib
import io
import math
import unittest

from check_ring_findings import ASSUMED_BEAM, ERRATUM, Table, later, near, printed_cs1, rpm


class Rows(unittest.TestCase):
    def verdict(self, *arguments):
        table, said = Table("ringstab"), io.StringIO()
        with contextlib.redirect_stdout(said):
            table.row(3, "claim", "measured", *arguments)
        return said.getvalue().rstrip("\n").rsplit("| ", 1)[1], table.unexpected

    def test_verdicts(self):
        self.assertEqual(self.verdict(True), ("yes", 0))
        self.assertEqual(self.verdict(False), ("no UNEXPECTED", 1))
        self.assertEqual(self.verdict(False, ERRATUM), ("no (erratum)", 0))
        self.assertEqual(self.verdict(False, ASSUMED_BEAM), ("not reproduced with the assumed beam", 0))
        self.assertEqual(self.verdict(True, ERRATUM), ("yes UNEXPECTED", 1))


class Comparisons(unittest.TestCase):
    def test_what_is_missing_is_neither_near_nor_later(self):
        self.assertTrue(near(1.0004, 1))
        self.assertFalse(near(1.002, 1))
        self.assertFalse(near(None, 1))
        self.assertTrue(later(1, 2, 3))
        self.assertFalse(later(1, 1))
        self.assertFalse(later(None, 1))

    def test_speeds_as_printed(self):
        self.assertEqual(rpm(1, None), "1.0000, none")


class PrintedFormula(unittest.TestCase):
    def test_its_square_is_negative_for_the_ring_of_figure_5(self):
        self.assertEqual(printed_cs1(17.2, 100), 0)

    def test_elsewhere_it_is_a_speed(self):
        # With omega_c = 1 and omega_r = 10 the square is (1000 + 24 - 16 sqrt(496)) / 50.
        self.assertAlmostEqual(printed_cs1(1, 10), math.sqrt((1024 - 16 * math.sqrt(496)) / 50) * 9.5493)
