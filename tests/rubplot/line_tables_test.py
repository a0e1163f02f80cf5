from line_fixture import LineTest
from rubplot.failure import Failure
from rubplot.line_tables import Line


class Tables(LineTest):
    def test_kinds_passes_and_label(self):
        line = self.line()
        self.assertEqual((line.kinds, line.passes, line.label), (" chaotic subharmonic_2 ", ["up"], "shaft speed (Hz)"))

    def test_what_no_program_wrote_is_refused(self):
        self.cells('up,50,"; system(1)",2,,,,\n')
        self.assertRaises(Failure, self.line)
        self.cells("sideways,50,chaotic,,,,,\n")
        self.assertRaises(Failure, self.line)
        self.cells("up,50,chaotic,,,,,\n", comment="")
        self.assertRaises(Failure, self.line)

    def test_the_place_on_an_axis_that_was_swept_logarithmically(self):
        self.write("config.yaml", "stops:\n  - kind: one_side\nsweep:\n  speed_hz:\n    from: 10\n    to: 100\n    scale: log\n")
        line = Line(self.directory)
        self.assertTrue(line.is_logarithmic)
        self.assertAlmostEqual(line.place({"value": "100"}), 2)
