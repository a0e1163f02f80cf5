"""Tables of keys in docs/keys.md. With the files of rubsweep, ringstab and the document as arguments: those are compared."""

import sys
import unittest

import key_tables

TEXT = """\
rotor
    the rotor
    map; required
rotor.mass_kg
    mass of a|b
    > 0; in kg; required; since 0.2.0
note
    anything
    text, at most 9 bytes; default (none)
"""


class Tables(unittest.TestCase):
    def test_rows(self):
        self.assertEqual(key_tables.rows(TEXT), [
            ("rotor", "the rotor", "map", "required"),
            ("rotor.mass_kg", "mass of a|b", "> 0 kg", "required (since 0.2.0)"),
            ("note", "anything", "text, at most 9 bytes", "(none)"),
        ])

    def test_keys_alone_come_first(self):
        text = key_tables.tables(TEXT)
        self.assertLess(text.index("`note`"), text.index("### rotor"))
        self.assertIn("| `rotor.mass_kg` | mass of a\\|b | > 0 kg | required (since 0.2.0) |\n", text)


class Document(unittest.TestCase):
    def test_it_says_what_the_programs_say(self):
        if not FILES:
            self.skipTest("no programs")
        rubsweep, ringstab, document = FILES
        with open(document, encoding="utf-8") as file:
            _, _, behind = file.read().partition(key_tables.MARKER)
        self.assertEqual(key_tables.MARKER + behind, key_tables.generated(rubsweep, ringstab),
                         f"packaging/key_tables.py {' '.join(FILES)} writes it anew")


FILES = sys.argv[1:4]

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
