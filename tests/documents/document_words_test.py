"""document_words_test.py SCRIPTS TOP: which words of documents are counted, what a page may have, and what is drawn to be read."""

import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPTS, TOP = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(SCRIPTS))
import document_words  # pylint: disable=wrong-import-position
import draw_sentences  # pylint: disable=wrong-import-position

TEXT = """\
# A title of five words

Two words. A [link with](of/its.md#address) text
goes on, `in code`.

| a table | is not |
|---|---|

    code is not

- one item
  of a list
- another

    code behind a list

```
fenced code
```

<!-- Made by a program. -->

Generated words.

<!-- End of what is made. -->

![A picture](x.png)

By hand again.
"""


class Words(unittest.TestCase):
    def test_words_by_hand(self):
        # 5 of the title, 10 of the first paragraph, 6 of the list, 3 at the end.
        self.assertEqual(document_words.words(TEXT), 5 + 10 + 6 + 3)

    def test_paragraphs_keep_their_lines(self):
        lines = TEXT.split("\n")
        for line, paragraph in document_words.prose(document_words.by_hand(TEXT)):
            self.assertIn(" ".join(paragraph.split()[:2]), lines[line - 1])

    def test_what_a_page_may_have(self):
        self.assertEqual([document_words.most_in(place) for place in ("README.md", "docs/method/proof.md", "docs/guide/maps.md")],
                         [900, 3000, 2500])

    def told(self, **files):
        with tempfile.TemporaryDirectory() as folder:
            for name, count in files.items():
                path = pathlib.Path(folder, name.replace("__", "/") + ".md")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text("# T\n\n" + "word " * (count - 1) + "\n", encoding="utf-8")
            with contextlib.redirect_stdout(io.StringIO()) as out:
                code = document_words.main(pathlib.Path(folder))
        return code, out.getvalue()

    def test_limits(self):
        self.assertEqual(self.told(README=900, docs__method__a=3000, docs__b=2500)[0], 0)
        for files in ({"README": 901}, {"docs__method__a": 3001}, {"docs__b": 2501}, {f"docs__p{i}": 2500 for i in range(23)}):
            code, text = self.told(**files)
            self.assertEqual(code, 1, files)
            self.assertIn("allowed: ", text)
        self.assertEqual(self.told(CHANGELOG=9000, docs__library__page=9000, README=5)[0], 0)

    def test_the_tree_keeps_them(self):
        done = subprocess.run([sys.executable, "-B", SCRIPTS / "document_words.py", TOP], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout[-600:])


class Draws(unittest.TestCase):
    def read(self, read, name, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, name)
            path.write_text(text, encoding="utf-8")
            return read(path)

    def test_sentences(self):
        found = self.read(draw_sentences.sentences, "a.md", "# T\n\nThe first of them ends. The second has `e.g. code` in\nit. No.\n")
        self.assertEqual(found, [(3, "The first of them ends."), (3, "The second has `e.g. code` in it.")])

    def test_comments(self):
        found = self.read(draw_sentences.comments, "a.cpp", '/// A whole\n/// comment.\nint a;  ///< a trailing one\n'
                          'call("http://x y");\n}  // namespace rubsweep\n// last one\n')
        self.assertEqual(found, [(1, "A whole comment."), (3, "a trailing one"), (6, "last one")])

    def test_a_trailing_comment_goes_on_in_its_column_only(self):
        for mark in ("//", "///<"):
            found = self.read(draw_sentences.comments, "a.hpp", f"  int a;  {mark} begins here\n          {mark} and ends\n"
                              f"  // Comment of b.\n  int b;  {mark} short one\n  /// Comment\n  /// of c.\n  int c;\n")
            self.assertEqual(found, [(1, "begins here and ends"), (3, "Comment of b."), (4, "short one"), (5, "Comment of c.")])

    def test_a_seed_gives_one_sample(self):
        draw = lambda seed: subprocess.run([sys.executable, "-B", SCRIPTS / "draw_sentences.py", "sentences", "--count", "5", "--seed",
                                            str(seed), TOP / "README.md"], check=True, capture_output=True, text=True).stdout
        self.assertEqual(draw(3), draw(3))
        self.assertNotEqual(draw(3), draw(4))
        self.assertEqual(len(draw(3).splitlines()), 5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
