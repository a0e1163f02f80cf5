import unittest

from rubplot import lanes


class Lanes(unittest.TestCase):
    def test_labels_at_one_place_are_joined_by_their_word(self):
        self.assertEqual(lanes.joined([(0.5, "probe 1"), (0.2, "A"), (0.5, "probe 2"), (0.2, "B")]),
                         [(0.2, "A, B"), (0.5, "probe 1, 2")])

    def test_no_label_touches_another_of_its_row_and_all_stay_inside(self):
        named = [(k / 40, f"bearing number {k}") for k in range(41)]
        labels = lanes.lay_out(named, 0.01)
        self.assertEqual([label.at for label in labels], [share for share, _ in named])
        for row in range(lanes.rows(labels)):
            ends = [(label.middle - 0.005 * len(label.text), label.middle + 0.005 * len(label.text))
                    for label in labels if label.row == row]
            for (_, end), (begin, _) in zip(ends, ends[1:]):
                self.assertLess(end, begin)
            self.assertGreaterEqual(ends[0][0], -1e-12)
            self.assertLessEqual(ends[-1][1], 1 + 1e-12)

    def test_labels_with_room_have_one_row(self):
        self.assertEqual(lanes.rows(lanes.lay_out([(0.1, "A"), (0.9, "B")], 0.01)), 1)
        self.assertEqual(lanes.rows([]), 0)


if __name__ == "__main__":
    unittest.main()
