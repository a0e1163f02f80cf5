"""Reads a help as the programs print it."""

import unittest

import help_text

TEXT = """\
rubtry CONFIG.yaml --cell X,Y [options]
rubtry --map DIR [options]
Tries a cell: once,
or never.

Options:
  --cell SPEED_HZ,UNBALANCE the cell, which is
                            wide
  --threads N (=0)          threads; 0: one
                            per processor
  --quiet                   print errors only

Examples:
  rubtry my.yaml --cell 1,2
  rubtry --map \\
      results

Writes DIR:
  a.csv  a row
         for each

Exit codes: 0 done; 1 usage; 128+signal when
interrupted.
"""


class Help(unittest.TestCase):
    def setUp(self):
        self.read = help_text.parse(TEXT)

    def test_usages_and_purpose(self):
        self.assertEqual(self.read.usage, ["rubtry CONFIG.yaml --cell X,Y [options]", "rubtry --map DIR [options]"])
        self.assertEqual(self.read.purpose, "Tries a cell: once, or never.")

    def test_an_option_wider_than_its_column(self):
        self.assertEqual(self.read.options[0], help_text.Option("cell", "SPEED_HZ,UNBALANCE", "", "the cell, which is wide"))

    def test_defaults_and_flags(self):
        self.assertEqual(self.read.options[1:], [
            help_text.Option("threads", "N", "(=0)", "threads; 0: one per processor"),
            help_text.Option("quiet", "", "", "print errors only"),
        ])

    def test_examples_rest_and_exit_codes(self):
        self.assertEqual(self.read.examples, ["  rubtry my.yaml --cell 1,2", "  rubtry --map \\", "      results"])
        self.assertEqual(self.read.rest, [["Writes DIR:", "  a.csv  a row", "         for each"]])
        self.assertEqual(self.read.exit_codes, "0 done; 1 usage; 128+signal when interrupted.")

    def test_exit_codes_behind_a_line(self):
        read = help_text.parse(TEXT.replace("for each\n\nExit", "for each\nExit"))
        self.assertEqual(read.exit_codes, self.read.exit_codes)
        self.assertEqual(read.rest, self.read.rest)

    def test_a_help_without_exit_codes_is_refused(self):
        with self.assertRaisesRegex(ValueError, "exit_codes"):
            help_text.parse(TEXT.split("Exit codes")[0])


if __name__ == "__main__":
    unittest.main()
