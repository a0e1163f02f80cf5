import argparse

import figures
from rubplot.pictures import run_up


class RunUp(figures.FigureTest):
    def setUp(self):
        super().setUp()
        self.write("config.yaml", "stops:\n  - kind: one_side\n    angle_deg: 90\n    clearance_m: 0.001\n")
        self.write("envelope.csv", "speed_hz,lowest_y_m,highest_y_m,peak_displacement_m\n20,-0.001,0.002,0.003\n30,0,0,0\n")
        self.write("quasi_static.csv", "speed_hz,peak_displacement_m\n20,0.001\n25,\n")
        self.write("orbits.csv", "orbit,speed_hz,x_m,y_m\n0,22,0.003,0.004\n0,22,0,0\n1,28,0,0.001\n")
        self.write("spectrogram.csv", "speed_hz,order,amplitude_m\n20,0,9\n20,-2.5,0.001\n20,1,0.002\n24,1,0.003\n24,7,1e-6\n")
        self.write("rub.csv", "source,from_hz,to_hz\nramp,30,20\nquasi_static,22,28\n")

    def picture(self):
        return run_up.picture(argparse.Namespace(source=self.directory, heading="Run-up"))

    def lines(self, name):
        return list(self.picture().files[name])

    def test_all_of_it_in_millimetres(self):
        self.assertEqual(self.picture().arguments, ("Run-up", "20 30 Hz", "1 90", "22 28", "5.5", "3", ""))
        self.assertEqual(self.lines("envelope"), ["20 -1 2 3", "30 0 0 0"])
        self.assertEqual(self.lines("steady"), ["20 1"])
        self.assertEqual(self.lines("orbits"), ["3 4", "0 0", "", "", "0 1"])
        self.assertEqual(self.lines("rub"), ["20 30 1", "22 28 0"])

    def test_spectra_reach_half_way_to_their_neighbours_and_the_largest_is_on_top(self):
        lines = [[float(number) for number in line.split()] for line in self.lines("spectrogram")]
        self.assertEqual([line[:4] for line in lines], [[24, 7, 22, 26], [20, -2.5, 18, 22], [20, 1, 18, 22], [24, 1, 22, 26]])

    def test_a_ring_has_no_angle(self):
        self.write("config.yaml", "stops:\n  - kind: annular\n    clearance_m: 0.001\n")
        self.assertEqual(self.picture().arguments[2], "1 nan")

    def test_labels_have_units(self):
        words = figures.words(self.draw("run-up"))
        for text in ("shaft speed (Hz)", "displacement (mm)", "amplitude (mm)", "22 Hz", "at steady speed"):
            self.assertIn(text, words)
