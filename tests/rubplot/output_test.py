import os

from files import FileTest
from rubplot import output
from rubplot.failure import WrongCall


class Targets(FileTest):
    def test_the_ending_names_the_format(self):
        self.assertEqual(output.targets("a/b.PDF"), {"pdf": os.path.abspath("a/b.PDF")})
        self.assertEqual(output.targets("a/b.c", ("svg", "pdf")),
                         {"svg": os.path.abspath("a/b.c.svg"), "pdf": os.path.abspath("a/b.c.pdf")})
        self.assertEqual(list(output.targets("b")), ["png", "svg"])

    def test_what_cannot_be_meant_is_refused(self):
        for name, formats in (("b.jpg", None), ("b.png", ("svg",)), (self.directory, None), ("", None)):
            with self.subTest(name=name), self.assertRaises(WrongCall):
                output.targets(name, formats)
        with self.assertRaisesRegex(WrongCall, "'eps' is not allowed, allowed: png, svg, pdf"):
            output.read_formats("png,eps")

    def test_a_picture_takes_the_place_of_an_older_one(self):
        drawn = self.write("drawn", "new")
        self.write("to/picture.png", "old")
        output.place(drawn, self.path("to/picture.png"))
        self.assertEqual(self.read("to/picture.png"), "new")
        self.assertEqual(os.listdir(self.path("to")), ["picture.png"])
