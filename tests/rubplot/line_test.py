import figures
from line_fixture import LineTest
from rubplot.failure import Failure
from rubplot.pictures import line

CONFIG = """\
title: Test_rig
author: N. N.
rotor:
  mass_kg: 0.8
  natural_frequency_hz: 30
  damping_ratio: 0.02
stops:
  - kind: one_side
    angle_deg: 90
    clearance_m: {clearance_m}
    stiffness_n_per_m: 2000000
    restitution: 0.7
kick:
  force_n: 45
  duration_s: 0.005
"""


class Layout(LineTest):
    def test_section_towards_the_wall(self):
        self.assertEqual(list(line.section_lines(self.line())),
                         ["50 2 1 subharmonic_2", "50 -3 1 subharmonic_2"])

    def test_peaks_of_cells_that_have_one(self):
        self.assertEqual(list(line.peak_lines(self.line())), ["50 4 1", ""])

    def test_a_section_of_a_cell_that_is_not_there_is_refused(self):
        self.cells("up,60,chaotic,,,,,\n")
        self.assertRaises(Failure, lambda: list(line.section_lines(self.line())))


class Drawn(figures.FigureTest):
    def write_line(self, along, clearance_m, sections_m):
        self.write("config.yaml", CONFIG.format(clearance_m=clearance_m))
        self.write("line.csv", f"# along {along}\npass,value,class,order,orbit,whirl,comb_spacing,peak_displacement_m\n" +
                   "".join(f"kick,{k},synchronous,1,complex,mixed,,0.002\n" for k in range(len(sections_m))))
        self.write("bifurcation.csv", "pass,value,x_m,y_m\n" + "".join(f"kick,{k},0,{y}\n" for k, y in enumerate(sections_m)))
        self.write("cascade.csv", "pass,value,order,amplitude_m\n" + "".join(f"kick,{k},1,0.001\n" for k in range(len(sections_m))))

    def clearance(self, root):
        return next((text for text in figures.texts(root) if text.text == "clearance at rest"), None)

    def test_the_wall_is_inside_its_panel_or_not_named(self):
        for sections_m, shown in (((-0.003, -0.002), True), ((0.002, 0.0021), True), ((1e-5, 2e-5), False)):
            with self.subTest(sections_m=sections_m):
                self.write_line("rotor.damping_ratio", 0.001, sections_m)
                found = self.clearance(self.draw("line", "--heading", "Bifurcations"))
                self.assertEqual(found is not None, shown)
                if shown:  # the upper panel reaches from 0.14 to 0.58 of the height of 1200
                    self.assertTrue(0.14 * 1200 < found.y < 0.58 * 1200)

    def test_the_heading_does_not_name_the_number_that_is_varied(self):
        for picture in ("line", "cascade"):
            for along, gone, left in (("stops.0.restitution", "nominal e", "K = "), ("kick.duration_s", " ms", "45 N")):
                with self.subTest(picture=picture, along=along):
                    self.write_line(along, 0.001, (-0.003, -0.002))
                    words = " ".join(figures.words(self.draw(picture, "--heading", "Bifurcations")))
                    self.assertNotIn(gone, words)
                    self.assertIn(left, words)
                    self.assertIn("Test_rig: Bifurcations", words)
                    self.assertIn("N. N.", words)

    def test_the_axis_is_named_once(self):
        self.write_line("rotor.damping_ratio", 0.001, (-0.003, -0.002))
        words = figures.words(self.draw("line", "--heading", "Bifurcations"))
        self.assertEqual(words.count("rotor.damping_ratio"), 1)
        self.assertIn("largest displacement (mm)", words)
        self.assertIn("section, towards the wall (mm)", words)

    def test_no_text_stands_over_another(self):
        for picture in ("line", "cascade"):
            for sections_m in ((-0.003, -0.002), (-2.5e-6, 1e-6), (0.01234, 0.01235)):
                with self.subTest(picture=picture, sections_m=sections_m):
                    self.write_line("rotor.damping_ratio", 0.001, sections_m)
                    self.assertEqual(figures.over_each_other(self.draw(picture, "--heading", "Bifurcations")), [])
