"""Kinds of what stands behind an option."""

import unittest

import completion
import help_text
from completed import Word

OVERVIEW = "usage: rubplot PICTURE\n\nDraws.\n\npictures:\n  map     maps of a sweep\n\nexit codes: 0 done"
PICTURE = """\
usage: rubplot map [-h]

options:
  -h, --help                show this help message and exit
  -o FILE, --output FILE    what ends with .png
                            is that file
  --formats LIST            some of png,svg,pdf (default: png,svg)
  --fade                    mix the colours
  --natural-frequency-hz F  draw speeds over it
  --kind {one,two}          which
  --a-name-that-is-wider-than-all VALUE
                            said below
"""


class Completion(unittest.TestCase):
    def test_kinds_by_the_name_of_the_value(self):
        options = [help_text.Option(*of) for of in (
            ("output", "DIR", "", "there"), ("figure", "FILE", "", "draw"), ("threads", "N", "(=0)", "many"),
            ("quiet", "", "", "errors"), ("progress", "WHEN", "(=auto)", "auto"))]
        one = completion.completed("rubtrace", help_text.Help(options=options))
        self.assertEqual([word.kind for word in one.options], ["folder", "file", "text", "", "word"])
        self.assertEqual(one.options[4].words, ("auto", "always", "never"))
        self.assertEqual(one.source, "configuration")

    def test_pictures_have_options_of_their_own(self):
        one = completion.completed_pictures("rubplot", OVERVIEW, {"map": PICTURE})
        self.assertEqual(one.summaries, {"map": "maps of a sweep"})
        self.assertEqual(one.pictures["map"], (
            Word("help", "", (), "show this help message and exit"),
            Word("output", "file", (), "what ends with .png"),
            Word("formats", "word", ("png", "svg", "pdf"), "some of png,svg,pdf (default: png,svg)"),
            Word("fade", "", (), "mix the colours"),
            Word("natural-frequency-hz", "text", (), "draw speeds over it"),
            Word("kind", "word", ("one", "two"), "which"),
            Word("a-name-that-is-wider-than-all", "text", (), "said below"),
        ))


if __name__ == "__main__":
    unittest.main()
