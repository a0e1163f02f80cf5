import tempfile
import unittest
from pathlib import Path

from compared_results import compared


class ComparedResults(unittest.TestCase):
    def verdict(self, before, after, name="map.csv"):
        """Answer about two directories with one file of these texts, None: no file."""
        with tempfile.TemporaryDirectory() as top:
            folders = [Path(top) / folder for folder in ("before", "after")]
            for folder, text in zip(folders, (before, after)):
                folder.mkdir()
                if text is not None:
                    (folder / name).write_text(text, encoding="utf-8")
            return compared(*folders)

    def test_what_one_of_both_has_is_named(self):
        self.assertEqual(self.verdict("a,b\n1,2\n", "a,b\n1,2\n"), ("same", []))
        self.assertEqual(self.verdict("# old\na,b\n1,2\n", "# new\n\na,b\n1,2\n"), ("same", []))
        self.assertEqual(self.verdict("a,b\n1,2\n", "kind,a,b\nx,1,2\n"), ("named", ["map.csv: columns new: kind"]))
        self.assertEqual(self.verdict("a: 1\n", "a: 1\nb: 2\n", "c.yaml"), ("named", ["c.yaml: gone [], new ['b: 2']"]))
        self.assertEqual(self.verdict(None, "a\n"), ("named", ["map.csv: only after"]))

    def test_what_is_gone_is_a_difference(self):
        self.assertEqual(self.verdict("a\n", None)[0], "different")
        self.assertEqual(self.verdict("a,b\n1,2\n", "a\n1\n"), ("different", ["map.csv: columns gone: b"]))
        self.assertEqual(self.verdict("a\n1\n", "a\n1\n2\n"), ("different", ["map.csv: 1 rows -> 2"]))
        self.assertEqual(self.verdict("4\n", "0\n", "exit_code"), ("different", ["exit_code: 4 -> 0"]))

    def test_rounding_is_that_of_the_greatest_number_of_the_unit(self):
        small = self.verdict("peak_m,backward_m\n1,1e-20\n", "peak_m,backward_m\n1,2e-20\n")
        self.assertEqual(small, ("rounding", ["map.csv: backward_m in 1 of 1 rows, by up to 1.0e-20 of 1; row 1: 1e-20 -> 2e-20"]))
        self.assertEqual(self.verdict("k_n_per_m,x_m\n1e9,1e-4\n", "k_n_per_m,x_m\n1e9,1.1e-4\n")[0], "different")
        self.assertEqual(self.verdict("x\n0\n", "x\nnan\n")[0], "different")

    def test_words_differ(self):
        self.assertEqual(self.verdict("status\nok\n\"\"\n", "status\nok\nfailed\n"),
                         ("different", ["map.csv: status in 1 of 2 rows; row 2: nothing -> failed"]))
