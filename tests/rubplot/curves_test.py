import figures
from files import FileTest
from rubplot.csv_table import TableError
from rubplot.pictures import curves

POINTS = """# rubbranch 0.1.0
# parameter speed_hz
# curve_parameter whirl_ratio
curve,kind,parameter,curve_parameter
0,graze,1,0.1
0,graze,2,0.2
1,fold,3,0.3
2,graze,4,0.4
"""
MEETINGS = "curve,meeting,parameter,curve_parameter\n0,graze_fold,1.5,0.15\n1,graze_fold,1.5,0.15\n1,cusp,3,0.3\n"


class Layout(FileTest):
    def curves(self, points=POINTS):
        self.write("config.yaml", "rotor:\n  kind: jeffcott\n")
        self.write("meetings.csv", MEETINGS)
        path = self.write("curves.csv", points)
        return curves.Curves(path[: -len("/curves.csv")])

    def numbers(self, lines):
        return [tuple(round(float(text), 12) for text in line.split()) for line in lines]

    def test_curves_of_one_kind_are_not_joined(self):
        self.assertEqual(self.numbers(self.curves().line_lines("graze")), [(1, 0.1), (2, 0.2), (), (4, 0.4), ()])

    def test_kinds_and_parameters(self):
        curves = self.curves()
        self.assertEqual(curves.kinds(), ["fold", "graze"])
        self.assertEqual(curves.parameters, ("speed_hz", "whirl_ratio"))

    def test_a_meeting_of_two_curves_is_marked_once(self):
        self.assertEqual([line.split()[2] for line in self.curves().mark_lines()], ["graze_fold", "cusp"])

    def test_names_of_meetings_do_not_stand_on_each_other(self):
        self.curves()
        self.write("meetings.csv", MEETINGS + "1,cusp,3.1,0.301\n1,fold,3.2,0.299\n1,cusp,3,0.35\n")
        self.assertEqual([line.split(maxsplit=2)[2] for line in curves.Curves(self.directory).mark_lines()],
                         ["graze_fold", "cusp,fold", '""', '""', "cusp"])

    def test_no_curves(self):
        with self.assertRaises(TableError):
            self.curves("curve,kind,parameter,curve_parameter\n")


CONFIG = """rotor:
  kind: jeffcott
sweep:
  speed_rpm:
    values: [60, 120, 180, 240]
  whirl_ratio:
    values: [0.1, 0.4]
"""


class Drawn(figures.FigureTest):
    def setUp(self):
        super().setUp()
        self.write("config.yaml", CONFIG)
        self.write("curves.csv", POINTS)
        self.write("meetings.csv", MEETINGS)

    def test_both_parameters_are_in_the_units_of_the_configuration_with_and_without_a_map(self):
        words = figures.words(self.draw("curves"))
        for text in ("shaft speed (rpm)", "whirl ratio (quiet whirl / clearance)", "fold", "cusp"):
            self.assertIn(text, words)
        self.write("map/config.yaml", CONFIG)
        self.write("map/map.csv", "speed_hz,whirl_ratio,class,order,orbit,whirl,comb_spacing\n" + "".join(
            f"{hz},{ratio},chaotic,,,,\n" for ratio in (0.1, 0.4) for hz in (1, 2, 3, 4)))
        words = figures.words(self.draw("curves", "--map", self.path("map")))
        for text in ("shaft speed (rpm)", "chaotic", "fold"):
            self.assertIn(text, words)

    def test_a_map_in_another_plane_is_refused(self):
        self.write("map/config.yaml", "sweep:\n  speed_hz:\n    values: [1]\n  eccentricity_m:\n    values: [1]\n")
        self.write("map/map.csv", "speed_hz\n")
        code, _, said = figures.rubplot("curves", self.directory, "--map", self.path("map"))
        self.assertEqual(code, 3)
        self.assertIn("is a map over speed_hz and eccentricity_m, the curves are over speed_hz and whirl_ratio", said)
