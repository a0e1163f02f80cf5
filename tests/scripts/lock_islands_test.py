import unittest
from types import SimpleNamespace

import lock_islands


def cells(*rows):
    """Cells at the speeds 1, 1.5, ...; # rubs. Each row is a whirl ratio."""
    return [SimpleNamespace(speed=1 + 0.5 * i, ratio=0.1 * k, rubs=lambda letter=letter: letter == "#")
            for k, row in enumerate(rows) for i, letter in enumerate(row)]


class Islands(unittest.TestCase):
    def test_cells_that_touch_at_a_corner_are_two_islands(self):
        self.assertEqual(sorted(map(len, lock_islands.islands(cells("#..", ".#.", ".##")))), [1, 3])

    def test_a_lock_speed_half_a_step_beside_counts(self):
        self.assertTrue(lock_islands.contains_lock_speed([2.25, 2.5], 0.5))
        self.assertFalse(lock_islands.contains_lock_speed([2.3, 2.5], 0.5))

    def test_a_stretch_begins_behind_a_cell_that_does_not_rub(self):
        self.assertEqual(lock_islands.begins(cells("##.##", "..#..")), [2.5, 2.0])

    def test_summary_counts_islands_cells_and_begins(self):
        # Speeds 1 to 3: two islands, of which that at 2 holds a lock speed.
        self.assertEqual(lock_islands.summary(cells("#.#..", "..#..")),
                         "1 of 2 islands with a lock speed, 2 of 3 cells; 2 of 2 stretches begin just above one, "
                         "as 2 of 4 speeds are")


if __name__ == "__main__":
    unittest.main()
