import line_layout
from command import Failure
from files import FileTest

HEADER = "pass,value,class,order,orbit,whirl,comb_spacing,peak_displacement_m\n"


class Directory(FileTest):
    def setUp(self):
        super().setUp()
        self.write("config.yaml", "stops:\n  - kind: one_side\n    angle_deg: 90\n    clearance_m: 0.001\n")
        self.write("bifurcation.csv", "pass,value,x_m,y_m\nup,50,0.001,0.002\nup,50,0,-0.003\n")
        self.write("cascade.csv", "pass,value,order,amplitude_m\nup,50,0,9\nup,50,1,0.002\nup,60,-2.5,0.001\nup,60,7,2.5e-9\n")
        self.cells("up,50,subharmonic,2,complex,mixed,,0.004\nup,60,chaotic,,,,,\n")

    def cells(self, rows, comment="# along speed_hz\n"):
        self.write("line.csv", "# rubsweep 1\n" + comment + HEADER + rows)

    def line(self):
        return line_layout.Line(self.directory)

    def test_section_towards_the_wall(self):
        self.assertEqual(list(line_layout.section_lines(self.line())),
                         ["50 2 1 subharmonic_2", "50 -3 1 subharmonic_2"])

    def test_peaks_of_cells_that_have_one(self):
        self.assertEqual(list(line_layout.peak_lines(self.line())), ["50 4 1", ""])

    def test_kinds_passes_and_label(self):
        line = self.line()
        self.assertEqual((line.kinds, line.passes, line.label), (" chaotic subharmonic_2 ", ["up"], "shaft speed (Hz)"))

    def test_spectra_from_the_back_to_the_front(self):
        spectra = line_layout.spectra(self.line())
        self.assertEqual([(s.value, s.kind, s.lines) for s in spectra["up"]],
                         [(60.0, "chaotic", [(-2.5, 1.0), (7.0, 2.5e-6)]), (50.0, "subharmonic_2", [(1.0, 2.0)])])
        self.assertEqual(line_layout.largest_amplitude(spectra), 2.0)
        self.assertEqual(line_layout.largest_order(spectra), 3)

    def test_an_outline_stands_on_its_value(self):
        spectrum = line_layout.Spectrum(50.0, "chaotic")
        spectrum.lines = [(-9.0, 5.0), (0.5, 1.0), (0.51, 2.0)]  # one beyond the picture, two in one peak
        points = spectrum.outline(2, 10)
        self.assertEqual(points[0], (-2, 50.0))
        self.assertEqual(points[-1], (2, 50.0))
        self.assertEqual([y for _, y in points], [50.0, 50.0, 60.0, 70.0, 50.0, 50.0])
        self.assertEqual([x for x, _ in points], sorted(x for x, _ in points))

    def test_what_no_program_wrote_is_refused(self):
        self.cells('up,50,"; system(1)",2,,,,\n')
        self.assertRaises(Failure, self.line)
        self.cells("sideways,50,chaotic,,,,,\n")
        self.assertRaises(Failure, self.line)
        self.cells("up,50,chaotic,,,,,\n", comment="")
        self.assertRaises(Failure, self.line)
        self.cells("up,60,chaotic,,,,,\n")
        line = self.line()
        self.assertRaises(Failure, lambda: list(line_layout.section_lines(line)))
