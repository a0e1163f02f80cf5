import unittest

import figures
from line_fixture import LineTest
from rubplot.pictures import cascade


class Layout(LineTest):
    def test_spectra_from_the_back_to_the_front(self):
        spectra = cascade.spectra(self.line())
        self.assertEqual([(s.place, s.kind, s.lines) for s in spectra["up"]],
                         [(60.0, "chaotic", [(-2.5, 1.0), (7.0, 2.5e-6)]), (50.0, "subharmonic_2", [(1.0, 2.0)])])
        self.assertEqual(cascade.largest_amplitude(spectra), 2.0)
        self.assertEqual(cascade.largest_order(spectra), 3)

    def test_an_outline_stands_on_its_value(self):
        spectrum = cascade.Spectrum(50.0, "chaotic")
        spectrum.lines = [(-9.0, 5.0), (0.5, 1.0), (0.51, 2.0)]  # one beyond the picture, two in one peak
        points = spectrum.outline(2, 10)
        self.assertEqual(points[0], (-2, 50.0))
        self.assertEqual(points[-1], (2, 50.0))
        self.assertEqual([y for _, y in points], [50.0, 50.0, 60.0, 70.0, 50.0, 50.0])
        self.assertEqual([x for x, _ in points], sorted(x for x, _ in points))


class Ticks(unittest.TestCase):
    def test_ticks_of_a_logarithmic_axis_lie_within_it(self):
        self.assertEqual(cascade.value_ticks(20, 150), '"20" 1.3010299956639813, "50" 1.6989700043360187, "100" 2')


class Drawn(figures.FigureTest):
    def draw_line(self, sweep):
        self.write("config.yaml", f"stops:\n  - kind: one_side\n    angle_deg: 90\n    clearance_m: 0.001\n{sweep}")
        self.write("line.csv", "# along speed_hz\npass,value,class,order,orbit,whirl,comb_spacing,peak_displacement_m\n" +
                   "".join(f"kick,{value},chaotic,,,,,0.002\n" for value in (10, 30, 100)))
        self.write("bifurcation.csv", "pass,value,x_m,y_m\nkick,10,0,0.001\n")
        self.write("cascade.csv", "pass,value,order,amplitude_m\n" + "".join(f"kick,{value},1,0.001\n" for value in (10, 30, 100)))
        root = self.draw("cascade")
        self.assertEqual(figures.over_each_other(root), [])
        return {text.text: text.y for text in figures.texts(root)}

    def test_a_logarithmic_axis_of_the_sweep_is_one_of_the_picture(self):
        found = self.draw_line("sweep:\n  speed_hz:\n    from: 10\n    to: 100\n    count: 3\n    scale: log\n")
        self.assertAlmostEqual(found["10"] - found["20"], found["50"] - found["100"], delta=2)
        found = self.draw_line("")
        self.assertAlmostEqual(found["20"] - found["40"], found["60"] - found["80"], delta=2)
        self.assertIn("shaft speed (Hz)", found)
        self.assertIn("order (× shaft speed)", found)
