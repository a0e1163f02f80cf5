import unittest

from rubplot import domain_map, refined_map


class RefinedMap(unittest.TestCase):
    def test_uniform_blocks_are_painted_and_others_split(self):
        known = {(i, j): "a" for i in (0, 4, 8) for j in (0, 4)}
        known.update({(8, 0): "b", (8, 4): "b"})
        known.update({(i, j): "a" for i in (6,) for j in (0, 2, 4)})
        known.update({(7, j): "b" for j in range(5)})
        known.update({(4, 2): "a", (8, 2): "b", (6, 1): "a", (6, 3): "a", (8, 1): "b", (8, 3): "b"})
        painted = refined_map.painted(known, 9, 5, 2)
        self.assertEqual(len(painted), 45)
        self.assertEqual({i for (i, _), label in painted.items() if label == "b"}, {7, 8})

    def test_lattice_ends_at_the_last_cell(self):
        self.assertEqual(refined_map.lattice(11, 2), [(0, 4), (4, 8), (8, 10)])
        self.assertEqual(refined_map.lattice(1, 2), [(0, 0)])

    def test_cells_lie_where_the_axes_say(self):
        cells = [domain_map.Cell(x, y, "chaotic") for x in (1.0, 3.0) for y in (0.1, 0.5)]
        painted = refined_map.painted_cells(cells, [1.0, 2.0, 3.0], [0.1, 0.3, 0.5], 1)
        self.assertEqual(len(painted), 9)
        self.assertIn(domain_map.Cell(2.0, 0.3, "chaotic"), painted)


if __name__ == "__main__":
    unittest.main()
