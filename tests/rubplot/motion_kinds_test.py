import unittest

from rubplot import motion_kinds


class Table(unittest.TestCase):
    def test_it_has_every_kind_with_a_colour(self):
        self.assertEqual(len(motion_kinds.KINDS), 19)
        for kind in motion_kinds.KINDS:
            self.assertTrue(motion_kinds.may_be_drawn(kind.name), kind)
            self.assertRegex(kind.colour, "^#[0-9A-F]{6}$")
        self.assertEqual([kind.name for kind in motion_kinds.KINDS if kind.hatched],
                         ["unsettled", "initial_contact", "failed"])

    def test_gnuplot_finds_three_arrays_of_one_length(self):
        lines = motion_kinds.gnuplot_arrays().splitlines()
        self.assertEqual(lines[0], "kinds = 19")
        self.assertEqual([line.split("[")[0] for line in lines[1:]], ["array kind", "array legend", "array colour"])
        self.assertEqual([line.count('"') for line in lines[1:]], [38] * 3)


class KindOf(unittest.TestCase):
    def test_a_map_says_it(self):
        row = {"class": "synchronous", "order": "1", "kind": "synchronous_circle"}
        self.assertEqual(motion_kinds.kind_of(row), "synchronous_circle")

    def test_maps_of_older_programs_show_class_and_order(self):
        for name, order, kind in (("subharmonic", "2", "subharmonic_2"), ("subharmonic", "18", "subharmonic_8"),
                                  ("chaotic", "", "chaotic")):
            self.assertEqual(motion_kinds.kind_of({"class": name, "order": order}), kind)


if __name__ == "__main__":
    unittest.main()
