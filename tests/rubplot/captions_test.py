import unittest

from rubplot import captions


class Captions(unittest.TestCase):
    def test_nothing_is_said_where_nothing_is_given(self):
        self.assertEqual((captions.title({}), captions.byline({}), captions.headed("Map", {})), ("", "", "Map"))

    def test_texts_as_a_program_writes_them(self):
        config = {"title": "Test rig 4", "note": '"a \\"b\\" \\x7f\\nmore"'}
        self.assertEqual(captions.headed("Map", config), "Test rig 4: Map")
        self.assertEqual(captions.byline(config), 'a "b" \x7f')

    def test_a_long_note_ends_where_the_picture_does(self):
        self.assertEqual(len(captions.byline({"author": "N. N.", "note": "x" * 500})), captions.LONGEST)


if __name__ == "__main__":
    unittest.main()
