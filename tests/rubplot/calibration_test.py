import figures
from rubplot.calibration import Calibration, chi_square
from rubplot.pictures import calibration

HEADER = "machine,truth,no_rub,one_side,two_sides,annular,annular_offset,none,rule,nearest,share_of_nearest,effective_cases,rank_of_clearance_m,rank_of_stop_angle_deg"


def row(truth, one_side, none, rank="", share=0.5, angle="", cases=100):
    """A recording: one_side has the share `one_side` of what is not none, and no_rub the rest."""
    return f"1,{truth},{1 - one_side},{one_side},0,0,0,{none},no_rub,one_side,{share},{cases},{rank},{angle}"


class CalibrationTest(figures.FigureTest):
    def table(self, *rows):
        return self.write("calibration.csv", "\n".join((HEADER, *rows)) + "\n")

    def calibration(self, *rows):
        return Calibration.of_tables([self.table(*rows)])

    def test_statements_are_counted_by_tenths_with_none_of_these(self):
        found = list(self.calibration(row("one_side", 0.95, 0), row("no_rub", 0.91, 0), row("oil_whirl", 0.5, 0.92)).statements())
        likeliest = found[-1]
        self.assertEqual(likeliest.count, 3)
        self.assertAlmostEqual(likeliest.mean, (0.95 + 0.91 + 0.92) / 3)
        self.assertAlmostEqual(likeliest.right, 2 / 3)
        self.assertAlmostEqual(likeliest.deviation, (likeliest.mean * (1 - likeliest.mean) / 3) ** 0.5)
        self.assertEqual(sum(tenth.count for tenth in found), 3 * 6)

    def test_the_first_is_the_likeliest_after_none_took_its_share(self):
        found = self.calibration(row("one_side", 0.9, 0.6), row("one_side", 0.9, 0.1), row("no_rub", 0.2, 0, share=0.9))
        self.assertEqual(found.firsts("one_side"), {"none": 1, "one_side": 1})
        self.assertEqual(len(found.of_candidates()), 3)
        self.assertEqual([one["truth"] for one in found.of_candidates(telling=True)], ["no_rub"])

    def test_ranks_are_those_that_a_cause_has(self):
        found = self.calibration(row("one_side", 1, 0, "0.1", angle="0.7"), row("annular", 1, 0, "1.0"), row("no_rub", 0, 0),
                                 row("oil_whirl", 0, 1))
        self.assertEqual(found.ranks("rank_of_clearance_m"), [0.1, 1.0])
        self.assertEqual(found.ranks("rank_of_stop_angle_deg"), [0.7])
        self.assertEqual(found.counts("rank_of_clearance_m"), [1, 0, 0, 0, 1])
        self.assertAlmostEqual(chi_square([1, 0, 0, 0, 1]), 3)
        self.assertEqual(found.other_truths(), ["oil_whirl"])

    def test_equal_cases_are_those_of_rubs(self):
        found = self.calibration(row("one_side", 1, 0, cases=50), row("annular", 0, 0, cases=20), row("no_rub", 0, 0, cases=5),
                                 row("oil_whirl", 0, 1, cases=""))
        self.assertEqual(found.equal_cases(), [20, 50])

    def test_intervals_hold_what_lies_between_their_ends(self):
        found = self.calibration(*(row("one_side", 1, 0, place) for place in (0.01, 0.03, 0.5, 0.97, 0.99)), row("two_sides", 0, 0, 0.5))
        self.assertAlmostEqual(found.inside("rank_of_clearance_m"), 4 / 6)
        self.assertAlmostEqual(found.inside("rank_of_clearance_m", "one_side"), 0.6)
        self.assertAlmostEqual(found.inside("rank_of_clearance_m", "two_sides"), 1)
        self.assertAlmostEqual(found.inside("rank_of_clearance_m", "one_side", 0.99), 1)

    def test_every_truth_and_answer_has_a_cell(self):
        found = self.calibration(row("one_side", 0.9, 0), row("oil_whirl", 0.1, 0.9))
        cells = [line.split() for line in calibration.firsts(found)]
        self.assertEqual(len(cells), 6 * 6)
        self.assertIn(["1", "-1", "1", "1"], cells)
        self.assertIn(["5", "-5", "1", "1"], cells)

    def test_the_picture_says_what_it_shows(self):
        self.table(row("one_side", 0.95, 0, "0.3"), row("no_rub", 0.4, 0.1, "0.7"), row("oil_whirl", 0.5, 0.92))
        words = figures.words(self.draw("calibration", source="calibration.csv"))
        for word in ("Statements", "Answer that came first", "one side", "oil whirl", "none", "clearance"):
            self.assertIn(word, words)
