import changed_labels
from files import FileTest
from rubplot.failure import Failure

HEADER = "speed_hz,whirl_ratio,class,order,orbit\n"


class ChangedLabels(FileTest):
    def test_labels_have_the_order_of_subharmonics_and_the_orbit_of_what_repeats(self):
        row = {"class": "subharmonic", "order": "3", "orbit": "complex"}
        self.assertEqual(changed_labels.label(row), "subharmonic 1/3 complex")
        self.assertEqual(changed_labels.label({"class": "synchronous", "order": "1", "orbit": "oval"}), "synchronous oval")
        self.assertEqual(changed_labels.label({"class": "chaotic", "order": "", "orbit": "complex"}), "chaotic")

    def test_only_cells_with_another_label_are_changed(self):
        before = self.write("before.csv", HEADER + "45,0.1,non_contact,,circle\n48,0.1,chaotic,,\n51,0.1,subharmonic,2,oval\n")
        after = self.write("after.csv", HEADER + "45,0.1,non_contact,,\n48,0.1,unsettled,,\n51,0.1,subharmonic,4,oval\n")
        self.assertEqual(
            changed_labels.changed_cells(before, after),
            [("48", "0.1", "chaotic", "unsettled"), ("51", "0.1", "subharmonic 1/2 oval", "subharmonic 1/4 oval")],
        )

    def test_maps_of_other_cells_are_refused(self):
        before = self.write("before.csv", HEADER + "45,0.1,non_contact,,\n")
        after = self.write("after.csv", HEADER + "46,0.1,non_contact,,\n")
        with self.assertRaises(Failure):
            changed_labels.changed_cells(before, after)

    def test_rounding_decides_where_a_program_gives_the_label_of_the_other_or_each_several(self):
        old, new = "chaotic", "non_contact"
        decides = changed_labels.rounding_decides
        self.assertTrue(decides([old, new, old], [new, new, new]))
        self.assertTrue(decides([old, old, old], [new, old, new]))
        self.assertTrue(decides([old, "unsettled"], [new, "quasi_periodic"]))
        self.assertFalse(decides([old, "unsettled", old], [new, new, new]))
        self.assertFalse(decides([old, old], [new, new]))

    def test_turns_decide_where_more_of_them_give_the_label_of_the_other(self):
        class Known:
            def __init__(self, always, longer):
                self.always, self.later = always, longer

            def labels(self, *_):
                return [self.always] * 2

            def longer(self, *_):
                return self.later

        def decided(before, after):
            line = changed_labels.changed_line(before, after, ("45", "0.1"), before.always, after.always)
            return line.split(",")[-1]

        self.assertEqual(decided(Known("unsettled", "chaotic"), Known("chaotic", "chaotic")), "turns")
        self.assertEqual(decided(Known("chaotic", "chaotic"), Known("unsettled", "chaotic")), "turns")
        self.assertEqual(decided(Known("unsettled", "unsettled"), Known("chaotic", "chaotic")), "program")

    def test_counts_labels_from_the_most_frequent_on(self):
        self.assertEqual(changed_labels.counted(["a", "b", "b"]), "b 2; a 1")

    def test_kicks_differ_by_next_to_nothing_and_one_is_the_kick_itself(self):
        self.assertEqual(len(set(changed_labels.KICK_CHANGES)), 11)
        self.assertIn(0.0, changed_labels.KICK_CHANGES)
        self.assertLessEqual(max(map(abs, changed_labels.KICK_CHANGES)), 1e-8)
