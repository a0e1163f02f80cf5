"""Pages of the reference. With docs, rubplot and the programs as arguments: docs/reference and the generated part of docs/keys.md
are compared with what these say."""

import glob
import os
import re
import sys
import unittest

import key_tables
import reference_pages

KEYS = """\
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


class Keys(unittest.TestCase):
    def test_rows(self):
        self.assertEqual(key_tables.rows(KEYS), [
            ("rotor", "the rotor", "map", "required"),
            ("rotor.mass_kg", "mass of a|b", "> 0 kg", "required (since 0.2.0)"),
            ("note", "anything", "text, at most 9 bytes", "(none)"),
        ])

    def test_sections(self):
        sections = key_tables.sections_of(KEYS)
        self.assertEqual({name: len(rows) for name, rows in sections.items()}, {"rotor": 2, "note": 1})
        self.assertIn("| `rotor.mass_kg` | mass of a\\|b | > 0 kg | required (since 0.2.0) |\n",
                      key_tables.table_of(sections["rotor"]))
        self.assertEqual(key_tables.units(KEYS), [("mass_kg", "kg")])


class Paragraphs(unittest.TestCase):
    def test_prose_with_a_table(self):
        self.assertEqual(reference_pages.paragraph(["Writes into DIR:", "  a.csv    rows, x < y", "           and more", "Then it",
                                                    "ends."]),
                         "Writes into DIR:\n\n|  |  |\n|---|---|\n| `a.csv` | rows, x &lt; y and more |\n\nThen it ends.\n")

    def test_a_file_is_code(self):
        self.assertEqual(reference_pages.paragraph(["The file, for example:", "  time: t", "  probes:", "    - {column: X}"]),
                         "The file, for example:\n\n    time: t\n    probes:\n      - {column: X}\n")

    def test_tables_by_their_headings(self):
        self.assertEqual(reference_pages.tables_of_help([["Said.", "Writes:", "  a, b  both", "        of them", "More:", "  c  it"]]),
                         [("Writes:", [("a, b", "both of them")]), ("More:", [("c", "it")])])

    def test_no_line_begins_a_list(self):
        self.assertEqual(reference_pages.wrapped("one - two # three 1. four", 5), ["one -", "two #", "three", "\\1.", "four"])

    def test_names_of_headings(self):
        self.assertEqual(reference_pages.anchor("map.csv"), "mapcsv")
        self.assertEqual(reference_pages.anchor("--cells FILE"), "--cells-file")


class Documents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not ARGUMENTS:
            raise unittest.SkipTest("no programs")
        cls.docs, rubplot, *programs = ARGUMENTS
        cls.pages, cls.keys = reference_pages.generated(rubplot, programs)

    def text(self, place):
        with open(os.path.join(self.docs, place), encoding="utf-8") as file:
            return file.read()

    def test_they_say_what_the_programs_say(self):
        again = "the target generated_documents writes it anew"
        paths = glob.glob(os.path.join(self.docs, "reference", "**", "*.md"), recursive=True)
        self.assertEqual({os.path.relpath(path, os.path.join(self.docs, "reference")) for path in paths}, set(self.pages), again)
        for place, text in self.pages.items():
            self.assertEqual(self.text("reference/" + place), text, again)
        _, _, behind = self.text("keys.md").partition(key_tables.MARKER)
        self.assertEqual(key_tables.MARKER + behind, self.keys, again)

    def test_every_key_is_on_one_page(self):
        said = [path for text in (self.keys, *self.pages.values()) for path in re.findall(r"^\| `([\w.]+)` \| .* \| .* \| .* \|$", text,
                                                                                       flags=re.MULTILINE)]
        self.assertGreater(len(said), 300)
        for path in ("title", "rotor.mass_kg", "stops.N.friction.coefficient", "sweep.refine", "loads.N.kind", "friction_coefficient"):
            self.assertIn(path, said)

    def test_every_program_has_its_parts(self):
        for name in ("rubsweep", "rubtrace", "ringstab"):
            text = self.pages[f"programs/{name}.md"]
            for part in ("## Options", "## Examples", "## Exit codes", "## Tables that it writes", "| `--quiet` |"):
                self.assertIn(part, text)
        self.assertIn("| – `step_limit` |", self.pages["programs/rubsweep.md"])
        self.assertIn("| – `resting_contact` |", self.pages["programs/rubsweep.md"])
        self.assertIn("| `hertz_stiffness_n_per_m` | N/m |", self.pages["programs/rubsweep.md"])
        self.assertIn("| `lyapunov_per_revolution` |  |", self.pages["programs/rubsweep.md"])
        self.assertIn("| `sha256` |  |", self.pages["programs/rubdata.md"])


ARGUMENTS = sys.argv[1:]

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
