import unittest

import findings_table

RECORD = """1: one side: gaps
   paper      A sentence | with a bar.
   counted    something
   reference  | 88 %, 72 % of the height | partly
   set B      | 12 | holds

2: both sides: casing
   threshold  holds from 90 % on
   reference  | 0 of 41 approaches | not reproduced
"""


class FindingsTable(unittest.TestCase):
    def test_findings_have_the_number_of_the_first_machine_and_every_verdict(self):
        found = findings_table.findings(RECORD)
        self.assertEqual(found[0], ("1: one side: gaps", [("reference", "88 %, 72 % of the height", "partly"), ("set B", "12", "holds")]))
        self.assertEqual(len(found), 2)

    def test_the_table_ends_with_counts(self):
        lines = findings_table.as_table(findings_table.findings(RECORD)).splitlines()
        self.assertEqual(lines[0], "| finding | reference | set B |")
        self.assertEqual(lines[2], "| 1: one side: gaps | partly: 88 %, 72 % of the height | holds |")
        self.assertEqual(lines[3], "| 2: both sides: casing | not reproduced: 0 of 41 approaches | |")
        self.assertEqual(lines[4], "| in all | 0 holds, 1 partly, 1 not reproduced | 1 holds, 0 partly, 0 not reproduced |")


if __name__ == "__main__":
    unittest.main()
