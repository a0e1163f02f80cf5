import figures
from files import FileTest
from rubplot.csv_table import TableError
from rubplot.pictures import branch

POINTS = """# rubbranch 0.1.0
# parameter speed_hz
branch,parameter,order,stable,amplitude_m
0,1,2,1,0.001
0,2,2,1,0.002
0,3,2,0,0.003
1,3,4,1,0.004
"""
EVENTS = "branch,kind,parameter,amplitude_m\n0,fold,2.5,0.0025\n0,graze,1.5,0.0015\n"


class Layout(FileTest):
    def branches(self, points=POINTS):
        self.write("config.yaml", "rotor:\n  kind: jeffcott\n")
        self.write("events.csv", EVENTS)
        path = self.write("branch.csv", points)
        return branch.Branches(path[: -len("/branch.csv")])

    def numbers(self, lines):
        return [tuple(round(float(text), 12) for text in line.split()) for line in lines]

    def test_pieces_reach_to_the_first_orbit_beyond_them(self):
        branches = self.branches()
        self.assertEqual(self.numbers(branches.line_lines(2, True)), [(1, 1), (2, 2), (3, 3), ()])
        self.assertEqual(self.numbers(branches.line_lines(2, False)), [(2, 2), (3, 3), ()])

    def test_branches_are_not_joined(self):
        self.assertEqual(self.numbers(self.branches().line_lines(4, True)), [(3, 4), ()])
        self.assertEqual(self.numbers(self.branches().line_lines(4, False)), [])

    def test_orders_marks_and_the_parameter(self):
        branches = self.branches()
        self.assertEqual(branches.orders(), [2, 4])
        self.assertEqual(branches.parameter, "speed_hz")
        self.assertEqual(self.numbers(branches.mark_lines("fold")), [(2.5, 2.5)])
        self.assertEqual(branches.mark_lines("neimark_sacker"), [])

    def test_no_orbits(self):
        with self.assertRaises(TableError):
            self.branches("branch,parameter,order,stable,amplitude_m\n")


class Drawn(figures.FigureTest):
    def draw_branch(self, sweep="", points=POINTS, events=EVENTS):
        self.write("config.yaml", "rotor:\n  kind: jeffcott\n  mass_kg: 0.8\n" + sweep)
        self.write("events.csv", events)
        self.write("branch.csv", points)
        root = self.draw("branch")
        self.assertEqual(figures.over_each_other(root), [])
        return figures.words(root)

    def test_the_parameter_is_in_the_unit_of_the_configuration(self):
        self.assertIn("shaft speed (Hz)", self.draw_branch())
        words = self.draw_branch("sweep:\n  speed_rpm:\n    from: 60\n    to: 240\n")
        self.assertIn("shaft speed (rpm)", words)
        self.assertIn("180", words)
        words = self.draw_branch("sweep:\n  unbalance_g_mm:\n    from: 1\n    to: 9\n", POINTS.replace("speed_hz", "eccentricity_m"))
        self.assertIn("unbalance (g mm)", words)
        self.assertIn("amplitude (mm)", words)

    def test_a_branch_without_events_is_drawn(self):
        words = self.draw_branch(events="branch,kind,parameter,amplitude_m\n")
        self.assertIn("order 2, stable", words)
        self.assertNotIn("fold", words)
