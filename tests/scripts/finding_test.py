import unittest

from finding import HOLDS, NO_MAP, NOT_REPRODUCED, PARTLY, Finding, Outcome, figure, of_both, of_share, percent
from sample_machine import SampleMachine


class Verdicts(unittest.TestCase):
    def test_two_conditions(self):
        self.assertEqual(of_both(True, True), HOLDS)
        self.assertEqual((of_both(True, False), of_both(False, True)), (PARTLY, PARTLY))
        self.assertEqual(of_both(False, False), NOT_REPRODUCED)

    def test_shares(self):
        for share, verdict in ((0.9, HOLDS), (0.89, PARTLY), (0.5, PARTLY), (0.49, NOT_REPRODUCED), (None, NOT_REPRODUCED)):
            self.assertEqual(of_share(share), verdict)
        self.assertEqual(of_share(0.8, 0.8, 0.6), HOLDS)

    def test_a_machine_without_the_map_has_no_verdict(self):
        finding = Finding("t", "p", "c", "t", "r", ("one_side", "annulus"), lambda machine: Outcome("1", HOLDS))
        self.assertEqual(finding.outcome(SampleMachine(one_side=[])).verdict, NO_MAP)
        self.assertEqual(finding.outcome(SampleMachine(one_side=[], annulus=[])).verdict, HOLDS)


class Text(unittest.TestCase):
    def test_figures(self):
        self.assertEqual((figure(2.34), figure(2.34, 1), figure(None)), ("2.34", "2.3", "-"))
        self.assertEqual((percent(1 / 3), percent(None)), ("33 %", "-"))
