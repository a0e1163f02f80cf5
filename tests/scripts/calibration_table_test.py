import unittest

import calibration_table
from rubplot.calibration import Calibration


def row(truth, one_side, none):
    """A recording: one_side has the share `one_side` of what is not none, and no_rub the rest."""
    return {"truth": truth, "no_rub": str(1 - one_side), "one_side": str(one_side), "two_sides": "0", "annular": "0",
            "annular_offset": "0", "none": str(none), "rule": "no_rub"}


class CalibrationTable(unittest.TestCase):
    calibration = Calibration([row("one_side", 0.95, 0), row("no_rub", 0.95, 0), row("oil_whirl", 0.5, 0.92)])

    def test_a_tenth_without_statements_is_left_out(self):
        lines = calibration_table.statements(self.calibration).splitlines()
        self.assertEqual([line.split(" |")[0] for line in lines[2:]], ["| 0 to 10 %", "| 90 to 100 %"])
        self.assertTrue(lines[-1].startswith("| 90 to 100 % | 3 | 0.940 | 0.667 | 0.137"), lines[-1])

    def test_every_truth_has_a_row_and_every_answer_a_column(self):
        lines = calibration_table.firsts(self.calibration).splitlines()
        self.assertEqual(lines[0], "| truth | first: no rub | one side | two sides | annular | annular, offset | none |")
        self.assertEqual(lines[2], "| no rub | | 1 | | | | |")
        self.assertEqual(lines[-1], "| oil whirl | | | | | | 1 |")


if __name__ == "__main__":
    unittest.main()
