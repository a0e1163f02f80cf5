import ring_layout
from command import Failure
from files import FileTest

EIGENVALUES = """# x
speed_rpm,mode,real_per_s,imaginary_rad_per_s
0,ring forward,1,10
0,ring backward,2,20
5,ring forward,3,30
"""
ONSETS = """kind,speed_rpm,modes,note
flutter_begin,0,ring backward,as soon as it turns
veering,6,ring backward,"gap 1, without friction"
coupling_end,7,a + b,
"""
CHART = """angle_deg,kind,speed_rpm,note
10,coupling_begin,500,"at 67 rad/s, without friction"
20,real_merger,600,"growing, divergence"
9.5,real_merger,700,growing
9.5,real_merger,800,growing
30,real_merger,700,decaying
"""


class LayOut(FileTest):
    def test_panel_from_a_speed_on(self):
        self.write("eigenvalues.csv", EIGENVALUES)
        self.write("onsets.csv", ONSETS)
        ring_layout.lay_out_panel(self.directory, 0)
        self.assertEqual(self.read("ring forward.curve"), "0 1 10\n5 3 30\n")
        self.assertEqual(self.read("ring backward.curve"), "0 2 20\n")
        self.assertEqual(self.read("onsets"), "0 flutter_begin\n7 coupling_end\n")
        ring_layout.lay_out_panel(self.directory, 5)
        self.assertEqual(self.read("ring forward.curve"), "5 3 30\n")
        self.assertEqual(self.read("onsets"), "7 coupling_end\n")

    def test_chart_by_kind_whatever_its_parameter_is_called(self):
        self.write("chart_onsets.csv", CHART)
        ring_layout.lay_out_chart(self.directory, self.path("out"))
        self.assertEqual(self.read("out.coupling_begin"), "10 500\n")
        self.assertEqual(self.read("out.flutter_end"), "")
        self.assertEqual(self.read("out.couplings"), "9.5\n20\n")

    def test_other_layouts_are_refused(self):
        with self.assertRaises(Failure):
            ring_layout.main(["map", self.directory, "0"])
