import cmath
import math

import figures
from rubplot.failure import Failure
from rubplot.pictures import fit

HEADER = "data,kind,sensor,part,at,measured_m,modelled_m\n"


def phasor_rows(number, kind, sensor, points):
    """Rows of complex (at, measured, modelled)."""
    points = list(points)
    return "".join(f"{number},{kind},{sensor},{part},{at},{getattr(measured, name)},{getattr(modelled, name)}\n"
                   for part, name in (("real", "real"), ("imaginary", "imag")) for at, measured, modelled in points)


def run_up(count=40):
    for k in range(count):
        speed = 20 + 0.5 * k
        model = 1e-5 * speed**2 / complex(900 - speed**2, 0.04 * 30 * speed)
        yield speed, 1.02 * model, model


class FitPicture(figures.FigureTest):
    def write_fit(self, rows, sweep="speed_hz"):
        self.write("config.yaml", f"sweep:\n  {sweep}:\n    from: 10\n    to: 20\n")
        self.write("fitted.csv", HEADER + rows)
        self.write("parameters.csv", "parameter,value,standard_error,low_95,high_95,start,at_bound\n"
                   "rotor.damping_ratio,0.02,1e-4,0.0198,0.0202,0.03,0\neccentricity_m,1e-5,inf,-inf,inf,1e-6,0\n"
                   "mark_deg,40,1,38,42,0,1\n")

    def test_phases_go_on_where_they_pass_a_turn(self):
        self.write_fit(phasor_rows(0, "run_up", 0, run_up()))
        found = fit.Fit(self.directory).files[0]
        phases = [float(line.split()[2]) for line in found.lower("0")]
        self.assertLess(max(abs(a - b) for a, b in zip(phases, phases[1:])), 90)
        amplitudes = [line.split() for line in found.upper("0")]
        self.assertAlmostEqual(float(amplitudes[5][1]) / float(amplitudes[5][2]), 1.02)

    def test_a_ring_down_shows_what_is_left(self):
        rows = "".join(f"0,ring_down,0,signal,{k / 100},{math.cos(k) * 1e-4 + 1e-6},{math.cos(k) * 1e-4}\n" for k in range(30))
        self.write_fit(rows)
        found = fit.Fit(self.directory).files[0]
        self.assertTrue(all(abs(float(line.split()[1]) - 1e-6 * found.left_per_metre) < 1e-9 * found.left_per_metre for line in found.lower("0")))

    def test_a_run_up_shows_what_is_left(self):
        self.write_fit(phasor_rows(0, "run_up", 0, run_up()))
        found = fit.Fit(self.directory).files[0]
        for line, (_, measured, model) in zip(found.lower("0"), run_up()):
            self.assertAlmostEqual(float(line.split()[3]), found.left_per_metre * abs(measured - model))
        self.assertEqual([fit.FittedFile._step(largest) for largest in (2.5, 0.9, 40, 1.99)], [1, 0.2, 20, 0.5])
        root = self.draw("fit")
        self.assertTrue(any(word.startswith("left (") for word in figures.words(root)))
        self.assertEqual(figures.over_each_other(root), [])

    def test_the_picture_says_what_it_shows(self):
        rows = "".join(f"0,ring_down,{i},signal,{k / 100},{math.cos(k) * 1e-4},{math.cos(k) * 1e-4}\n" for i in (0, 1) for k in range(30))
        rows += phasor_rows(1, "run_up", 0, run_up())
        rows += phasor_rows(2, "rub", 0, [(order, cmath.rect(1e-4, order), cmath.rect(1.1e-4, order)) for order in (-1, -0.5, 0.5, 1)])
        self.write_fit(rows)
        root = self.draw("fit", "--heading", "Kit 2")
        for word in ("Kit 2", "ring-down", "1X on a ramp", "lines of a rub", "time (s)", "shaft speed (Hz)", "order", "phase (deg)",
                     "rotor.damping_ratio = 0.02 ± 0.0002", "eccentricity_m = 1e-05, not told", "mark_deg = 40 ± 2 (at its bound)"):
            self.assertIn(word, figures.words(root))
        self.assertEqual(figures.over_each_other(root), [])

    def test_speeds_are_in_the_unit_of_the_configuration_or_the_one_that_is_asked_for(self):
        self.write_fit(phasor_rows(0, "run_up", 0, run_up()), sweep="speed_rpm")
        self.assertIn("shaft speed (rpm)", figures.words(self.draw("fit")))
        found = fit.Fit(self.directory).files[0]
        self.assertEqual(float(next(iter(found.upper("0"))).split()[0]), 1200)
        words = figures.words(self.draw("fit", "--speed-unit", "hz", "--length-unit", "mm"))
        for word in ("shaft speed (Hz)", "amplitude (mm)"):
            self.assertIn(word, words)

    def test_data_of_another_kind_are_refused(self):
        self.write_fit("0,sound,0,signal,0,1,1\n")
        with self.assertRaises(Failure):
            fit.Fit(self.directory)
