import figures
from files import FileTest
from rubplot.failure import Failure
from rubplot.pictures import ring

EIGENVALUES = """# title Test_rig
# author N. N.
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


class Panels(FileTest):
    def test_panel_from_a_speed_on(self):
        self.write("eigenvalues.csv", EIGENVALUES)
        self.write("onsets.csv", ONSETS)
        panel = ring.read_panel(self.directory, "a")
        self.assertEqual(panel.curves, {"ring forward": ["0 1 10", "5 3 30"], "ring backward": ["0 2 20"]})
        self.assertEqual(panel.onsets, [("0", "flutter_begin"), ("7", "coupling_end")])
        self.assertEqual((panel.from_rpm, panel.to_rpm), (0, 5))
        panel = ring.read_panel(self.directory, "a", from_rpm=5, to_rpm=9)
        self.assertEqual(panel.curves, {"ring forward": ["5 3 30"]})
        self.assertEqual(panel.onsets, [("7", "coupling_end")])

    def test_no_speed_and_no_kind(self):
        self.write("eigenvalues.csv", EIGENVALUES)
        self.write("onsets.csv", ONSETS.replace("coupling_end", "coupling'; system('ls') #"))
        self.assertRaisesRegex(Failure, "is no kind of onset", ring.read_panel, self.directory, "a")
        self.assertRaisesRegex(Failure, "no speed above 9 rpm", ring.read_panel, self.directory, "a", 9)


class Drawn(figures.FigureTest):
    def test_a_mode_that_no_figure_has_is_drawn_too_and_the_head_of_the_table_is_said(self):
        self.write("eigenvalues.csv", EIGENVALUES + "".join(f"{rpm},{mode},1,{rpm + 3}\n" for mode in ("load 7 radial", *ring.MODES[:2]) for rpm in (6, 7, 9)))
        self.write("onsets.csv", ONSETS)
        words = figures.words(self.draw("ring"))
        for text in ("Test_rig: Loads on an elastic ring", "N. N.", "load 7 radial", "speed (rpm)", "real part (1/s)",
                     "frequency (rad/s)"):
            self.assertIn(text, words)

    def test_several_directories_are_panels(self):
        for name in ("one", "two"):
            self.write(f"{name}/eigenvalues.csv", EIGENVALUES.replace("Test_rig", name) + "".join(f"{rpm},{mode},1,4\n" for mode in ring.MODES[:2] for rpm in (6, 9)))
            self.write(f"{name}/onsets.csv", ONSETS)
        words = figures.words(self.draw("ring", self.path("two"), source="one"))
        for text in ("one", "two", "Loads on an elastic ring"):
            self.assertIn(text, words)
