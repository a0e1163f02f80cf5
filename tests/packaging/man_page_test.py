"""Manual pages in the language of groff."""

import unittest

import help_text
import man_page

READ = help_text.Help(
    usage=["mpirun -n N rub-try MAP [options]"],
    purpose="Tries a map. Twice.",
    options=[help_text.Option("threads", "N", "(=0)", "all of them")],
    examples=["  rub-try 'a \\", "      b'"],
    rest=[["Columns:", "  one  first", "  two  second", "Behind them."], [".dotted line"]],
    exit_codes="0 done; 128+signal when interrupted.",
)


class ManPage(unittest.TestCase):
    def setUp(self):
        self.lines = man_page.page("rub-try", "1.2", READ, ["rub-try", "rubplot"]).split("\n")

    def test_name_is_the_first_sentence(self):
        self.assertIn("rub\\-try \\- Tries a map", self.lines)
        self.assertIn('.TH RUB-TRY 1 "" "rubsweep 1.2" "rubsweep"', self.lines)

    def test_usage_shows_the_program_in_bold(self):
        self.assertIn("mpirun \\-n N \\fBrub\\-try\\fR MAP [options]", self.lines)

    def test_options_with_value_and_default(self):
        at = self.lines.index("\\fB\\-\\-threads\\fR \\fIN\\fR (=0)")
        self.assertEqual(self.lines[at - 1], ".TP")
        self.assertEqual(self.lines[at + 1], "all of them")

    def test_rows_of_a_table_and_what_follows(self):
        at = self.lines.index("\\fIone\\fR")
        self.assertEqual(self.lines[at - 1 : at + 7],
                         [".TP", "\\fIone\\fR", "first", ".TP", "\\fItwo\\fR", "second", ".PP", "Behind them."])

    def test_a_file_keeps_its_lines_and_blanks(self):
        read = help_text.Help(**{**READ.__dict__, "rest": [["The file:", "  probes:", "    - {column: X}", "End."]]})
        lines = man_page.page("rub-try", "1.2", read, []).split("\n")
        at = lines.index("The file:")
        self.assertEqual(lines[at + 1 : at + 6], [".nf", "  probes:", "    \\- {column: X}", ".fi", "End."])

    def test_a_line_that_begins_with_a_dot_is_no_request(self):
        self.assertIn("\\&.dotted line", self.lines)

    def test_backslashes_of_examples_are_shown(self):
        self.assertIn("  rub\\-try 'a \\e", self.lines)

    def test_each_exit_code_is_an_item(self):
        self.assertIn("\\fB128+signal\\fR", self.lines)
        self.assertIn("when interrupted", self.lines)

    def test_other_programs_are_referred_to(self):
        self.assertIn("\\fBrubplot\\fR(1)", self.lines)


class Pictures(unittest.TestCase):
    OVERVIEW = "usage: rubplot PICTURE\n\nDraws. Much.\n\npictures:\n  map     maps\n  trace   runs\n\nexit codes: 0 done"

    def test_names(self):
        self.assertEqual(help_text.pictures_of(self.OVERVIEW), ["map", "trace"])

    def test_each_picture_has_a_part(self):
        text = man_page.page_of_pictures("rubplot", "1", self.OVERVIEW, {"map": "usage: rubplot map", "trace": "t"}, ["rubplot"])
        self.assertIn(".SS map\n.nf\nusage: rubplot map\n.fi", text)
        self.assertIn("rubplot \\- Draws\n", text)


if __name__ == "__main__":
    unittest.main()
