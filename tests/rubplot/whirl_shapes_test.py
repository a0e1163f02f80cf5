import math
import unittest

from rubplot import whirl_shapes


class WhirlShapes(unittest.TestCase):
    def test_the_major_axis_of_circle_line_and_ellipse(self):
        self.assertAlmostEqual(whirl_shapes.major(2, -2j), 2)
        self.assertAlmostEqual(whirl_shapes.major(3, 4), 5)
        self.assertAlmostEqual(whirl_shapes.major(1, -3j), 3)

    def test_the_place_that_moves_most_is_at_the_end_of_its_axis(self):
        for x, y in ((1 + 2j, 0.3 - 1j), (2j, 2), (0, 1j), (1 - 1j, 0)):
            shape = whirl_shapes.turned([(0.0, 0.1 * x, 0.1 * y), (1.0, x, y)])
            _, a, b = shape[1]
            self.assertAlmostEqual(math.hypot(a.real, b.real), whirl_shapes.major(x, y))
            self.assertAlmostEqual(abs(a), abs(x))

    def test_an_orbit_is_closed_and_of_the_size_that_is_drawn(self):
        shape = [(0.0, 0j, 0j), (2.0, 0j, 3e-6 + 0j)]
        blocks = "\n".join(whirl_shapes.orbit_lines(shape)).strip().split("\n\n")
        points = [tuple(map(float, line.split())) for line in blocks[1].split("\n")]
        self.assertEqual(points[0][0], 2000)
        self.assertAlmostEqual(max(point[1] for point in points), 1)
        self.assertAlmostEqual(points[0][1], points[-1][1])

    def test_of_many_places_some_are_shown_with_both_ends(self):
        self.assertEqual(list(whirl_shapes.spread(4)), [0, 1, 2, 3])
        places = whirl_shapes.spread(200)
        self.assertEqual((places[0], places[-1], len(places)), (0, 199, whirl_shapes.MOST_ORBITS))


if __name__ == "__main__":
    unittest.main()
