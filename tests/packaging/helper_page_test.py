"""Generated part of docs/for-helpers.md. With the document, rubplot and the programs as arguments: those are compared."""

import sys
import unittest

import helper_page
from help_text import parse

HELP = """\
spin CONFIG.yaml [options]
Turns.

Options:
  --help     print this
  --fast     turn fast

Examples:
  spin a.yaml --fast \\
      --help
  spin b.yaml

Exit codes: 0 done; 3 input/output: a file; or a folder; 4 stuck.
"""


class Section(unittest.TestCase):
    def test_it_holds_what_the_help_says(self):
        self.assertEqual(helper_page.section("spin", parse(HELP)), """\
### spin

Turns.

    spin CONFIG.yaml [options]

For example:

    spin a.yaml --fast --help

Exit codes:

- 0 done
- 3 input/output: a file; or a folder
- 4 stuck
""")

    def test_long_commands_go_on_in_the_next_line(self):
        lines = helper_page.wrapped(" ".join(["--option value"] * 20), "    ").splitlines()
        self.assertGreater(len(lines), 2)
        self.assertTrue(all(len(line) <= 120 for line in lines))
        self.assertTrue(all(line.endswith(" \\") for line in lines[:-1]))


class Numbers(unittest.TestCase):
    def test_a_key_that_is_gone_is_an_error(self):
        with self.assertRaises(KeyError):
            helper_page.numbers("rotor.mass_kg\n    mass\n    > 0; in kg; required\n")


class Document(unittest.TestCase):
    def test_it_says_what_the_programs_say(self):
        if not FILES:
            self.skipTest("no programs")
        document, rubplot, *programs = FILES
        with open(document, encoding="utf-8") as file:
            _, _, behind = file.read().partition(helper_page.MARKER)
        self.assertEqual(helper_page.MARKER + behind, helper_page.generated(rubplot, programs),
                         f"packaging/helper_page.py {' '.join(FILES)} writes it anew")


FILES = sys.argv[1:]

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
