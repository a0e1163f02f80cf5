import curve_layout
from csv_table import TableError
from files import FileTest

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
        self.write("meetings.csv", MEETINGS)
        path = self.write("curves.csv", points)
        return curve_layout.Curves(path[: -len("/curves.csv")])

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

    def test_no_curves(self):
        with self.assertRaises(TableError):
            self.curves("curve,kind,parameter,curve_parameter\n")
