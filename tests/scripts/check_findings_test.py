import unittest

import check_findings
from files import FileTest
from finding import HOLDS, NO_MAP, NOT_REPRODUCED
from rubplot.failure import Failure
from sample_machine import SampleMachine, circle, quiet


class Table(unittest.TestCase):
    def setUp(self):
        machines = [
            SampleMachine(name="empty"),
            SampleMachine(name="two circles", annulus=[circle(1.5, 0.4), circle(2.5, 0.6)] + quiet(0.4, 3, 4)),
        ]
        self.lines = list(check_findings.table(machines))
        self.verdicts = check_findings.read_verdicts(self.lines)

    def test_a_verdict_for_every_finding_and_machine(self):
        self.assertEqual(len(self.verdicts), 2 * len(check_findings.FINDINGS))
        title = "3: annulus: synchronous circle at low speed"
        self.assertEqual(self.verdicts[title, "two circles"], HOLDS)
        self.assertEqual(self.verdicts[title, "empty"], NO_MAP)

    def test_every_finding_says_what_is_counted_and_why(self):
        for name in ("paper", "counted", "threshold", "reason"):
            self.assertEqual(sum(line.startswith(f"   {name} ") for line in self.lines), len(check_findings.FINDINGS))

    def test_sums(self):
        self.assertEqual(self.lines[-2], f"empty: 0 holds, 0 partly, 0 not reproduced, {len(check_findings.FINDINGS)} no map")

    def test_brief_has_a_line_for_each_finding(self):
        lines = list(check_findings.brief(SampleMachine(name="two circles", annulus=[circle(1.5, 0.4), circle(2.5, 0.6)] + quiet(0.4, 3, 4))))
        rows = dict((cells[0], cells[2]) for cells in (line.split(" | ") for line in lines[1:-1]))
        self.assertTrue(lines[-1].startswith("two circles: "))
        self.assertEqual(rows, {title: verdict for (title, name), verdict in self.verdicts.items() if name == "two circles"})

    def test_titles_differ(self):
        self.assertEqual(len({finding.title for finding in check_findings.FINDINGS}), len(check_findings.FINDINGS))


class Differences(unittest.TestCase):
    EXPECTED = {("1: a", "A"): HOLDS, ("1: b", "A"): HOLDS}

    def test_only_verdicts_count(self):
        before = ["1: a", "   A          | 2.1 | holds"]
        after = ["1: a", "   A          | 2.2 | holds"]
        self.assertEqual(check_findings.read_verdicts(before), check_findings.read_verdicts(after))

    def test_a_changed_a_missing_and_a_new_row_are_named(self):
        found = {("1: a", "A"): NOT_REPRODUCED, ("1: c", "A"): HOLDS}
        self.assertEqual(
            list(check_findings.differences(self.EXPECTED, found)),
            [
                "1: a, A: expected 'holds', found 'not reproduced'",
                "1: b, A: expected 'holds', found 'no such row'",
                "1: c, A: expected 'no such row', found 'holds'",
            ],
        )
        self.assertEqual(list(check_findings.differences(self.EXPECTED, self.EXPECTED)), [])


class Directories(FileTest):
    def test_a_machine_of_ones_own_has_the_maps_that_are_there(self):
        self.write("annulus/map.csv", "")
        self.write("one_side/config.yaml", "")
        self.assertEqual(check_findings.own_directories(self.directory), {"annulus": self.path("annulus")})
        with self.assertRaisesRegex(Failure, "holds no map.csv in any of one_side, "):
            check_findings.own_directories(self.path("annulus"))
