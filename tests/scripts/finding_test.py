import unittest

from finding import HOLDS, NO_MAP, NOT_REPRODUCED, PARTLY, Finding, Outcome, figure, of_share, percent, with_and_without_filter
from sample_machine import SampleMachine


class Verdicts(unittest.TestCase):
    def test_what_holds_of_filtered_cells_alone_holds_partly(self):
        self.assertEqual(with_and_without_filter(True, False), HOLDS)
        self.assertEqual(with_and_without_filter(False, True), PARTLY)
        self.assertEqual(with_and_without_filter(False, False), NOT_REPRODUCED)

    def test_shares(self):
        for share, verdict in ((0.91, HOLDS), (0.9, PARTLY), (0.51, PARTLY), (0.5, NOT_REPRODUCED), (0, NOT_REPRODUCED)):
            self.assertEqual(of_share(share), verdict)

    def test_a_machine_without_the_map_has_no_verdict(self):
        finding = Finding("t", "p", "c", "c", "t", ("one_side", "annulus"), lambda machine: Outcome("1", "2", HOLDS))
        self.assertEqual(finding.outcome(SampleMachine(one_side=[])).verdict, NO_MAP)
        self.assertEqual(finding.outcome(SampleMachine(one_side=[], annulus=[])).verdict, HOLDS)


class Text(unittest.TestCase):
    def test_figures(self):
        self.assertEqual((figure(2.34), figure(2.34, 1), figure(None)), ("2.34", "2.3", "-"))
        self.assertEqual((percent(1, 3), percent(0, 0)), ("33 %", "0 %"))
