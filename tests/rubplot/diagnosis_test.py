import math

import figures
from rubplot.pictures import diagnosis


class Diagnosis(figures.FigureTest):
    def write_diagnosis(self, plane):
        def row(k):
            angle = math.pi * k / 16
            recorded, simulated = ((size * math.cos(angle), size * math.sin(angle)) for size in (5e-5, 6e-5))
            cells = (*recorded, *simulated) if plane else (recorded[0], simulated[0])
            return ",".join(str(cell) for cell in (k / 32, *cells)) + "\n"

        names = "turns,x_m,y_m,simulated_x_m,simulated_y_m" if plane else "turns,x_m,simulated_x_m"
        self.write("probabilities.csv", "candidate,probability\none_side,0.75\nno_rub,0.05\nnone_of_these,0.2\n")
        self.write("orbits.csv", names + "\n" + "".join(row(k) for k in range(33)))
        self.write("lines.csv", "order,recorded_m,simulated_m\n-1,1e-6,2e-6\n0.5,2e-5,1e-5\n1,5e-5,6e-5\n")

    def test_probabilities_stand_below_each_other_in_percent(self):
        self.write_diagnosis(plane=True)
        found = diagnosis.Diagnosis(self.directory)
        self.assertEqual(list(found.bars()), ['0 75 "one_side"', '-1 5 "no_rub"', '-2 20 "none_of_these"'])

    def test_two_probes_show_orbits_about_each_other(self):
        self.write_diagnosis(plane=True)
        found = diagnosis.Diagnosis(self.directory)
        self.assertEqual((found.unit, found.plane), ("mm", True))
        self.assertAlmostEqual(found.largest, 6e-5)
        self.assertEqual([round(float(cell), 9) for cell in next(found.orbit(found.simulated)).split()], [0.06, 0])
        self.assertEqual([float(line.split()[0]) for line in found.spectrum()], [-1, 0.5, 1])

    def test_one_probe_shows_its_reading_over_the_turns(self):
        self.write_diagnosis(plane=False)
        found = diagnosis.Diagnosis(self.directory)
        self.assertFalse(found.plane)
        # Turns are no length: the widest is that of the readings, and they keep their number.
        self.assertAlmostEqual(found.largest, 6e-5)
        self.assertEqual(float(list(found.orbit(found.recorded))[32].split()[0]), 1)
        self.assertIn("turns of the shaft", figures.words(self.draw("diagnosis")))

    def test_the_picture_says_what_it_shows(self):
        self.write_diagnosis(plane=True)
        root = self.draw("diagnosis", "--heading", "Kit 2")
        for word in ("Kit 2", "recorded", "closest simulated motion", "probability (%)", "one_side", "none_of_these", "x (mm)",
                     "y (mm)", "amplitude (mm)", "order (multiples of the speed)"):
            self.assertIn(word, figures.words(root))
        self.assertEqual(figures.over_each_other(root), [])

    def test_lengths_are_in_the_unit_that_is_asked_for(self):
        self.write_diagnosis(plane=True)
        self.assertIn("x (mil)", figures.words(self.draw("diagnosis", "--length-unit", "mil")))
