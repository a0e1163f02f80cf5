import math

import figures
from rubplot.pictures import scope


class Scope(figures.FigureTest):
    def write_recording(self, plane):
        def place(angle):
            return f"{5e-5 * math.cos(angle) + 1e-3}" + (f",{5e-5 * math.sin(angle)}" if plane else "")

        names = "x_m,y_m" if plane else "x_m"
        self.write("orbit.csv", f"turns,{names}\n" + "".join(f"{k / 16},{place(math.pi * k / 16)}\n" for k in range(32)))
        self.write("turns.csv", f"turn,t_s,speed_hz,{names}\n" + "".join(f"{k},{k / 50},50,{place(math.pi * k)}\n" for k in range(6)))
        self.write("lines.csv", "order,amplitude_m,uncertainty_m,phase_deg,phase_uncertainty_deg\n0,1e-3,1e-8,0,1\n0.5,5e-5,1e-8,0,1\n1,1e-7,1e-8,0,1\n")
        self.write("measures.csv", "quantity,value,uncertainty\nturns,6,\nperiod_turns,2,\n")

    def test_two_probes_show_a_closed_orbit_about_its_centre(self):
        self.write_recording(plane=True)
        found = scope.Scope(self.directory)
        lines = list(found.closed_orbit())
        self.assertEqual((found.unit, len(lines), lines[0]), ("mm", 33, lines[-1]))
        self.assertAlmostEqual(float(lines[0].split()[0]), 0.05)
        self.assertEqual(len(list(found.spectrum())), 2)

    def test_one_probe_shows_its_reading_over_the_turns_of_the_period(self):
        self.write_recording(plane=False)
        found = scope.Scope(self.directory)
        self.assertEqual([line.split()[0] for line in found.marks()], ["0", "1"] * 3)
        self.assertIn("turns of the shaft", figures.words(self.draw("scope")))

    def test_the_picture_says_what_it_shows(self):
        self.write_recording(plane=True)
        root = self.draw("scope", "--heading", "Kit 2")
        for word in ("Kit 2", "mean motion, period 2 turns", "at the mark", "x (mm)", "y (mm)", "order", "amplitude (mm)",
                     "noise of a line", "shaft speed (Hz)", "time (s)"):
            self.assertIn(word, figures.words(root))
        self.assertEqual(figures.over_each_other(root), [])

    def test_a_simulated_motion_is_laid_over_it(self):
        self.write_recording(plane=True)
        self.write("simulated.csv", "turns,x_m,y_m\n" + "".join(f"{k / 16},{6e-5 * math.cos(math.pi * k / 16)},{6e-5 * math.sin(math.pi * k / 16)}\n" for k in range(32)))
        self.write("compared.csv", "order,measured_m,measured_phase_deg,simulated_m,simulated_phase_deg,difference\n0.5,5e-5,0,6e-5,0,900\n")
        self.assertAlmostEqual(scope.Scope(self.directory).widest(), 1.1 * 0.06)
        root = self.draw("scope")
        self.assertIn("simulated", figures.words(root))
        self.assertEqual(figures.over_each_other(root), [])

    def test_a_run_up_has_a_bode_plot(self):
        def phase(k):
            return -math.degrees(math.atan2(0.1 * k, 20 - k)) if k else 0.0

        self.write("bode.csv", "t_s,speed_hz,order,x_amplitude_m,x_phase_deg\n" + "".join(f"{k},{10 + k},{order},{1e-5 / (1 + abs(k - 20))},{phase(k)}\n" for order in (1, 2) for k in range(40)))
        self.write("waterfall.csv", "t_s,speed_hz,order,amplitude_m\n" + "".join(f"{k},{10 + k},{order},1e-6\n" for k in range(0, 40, 8) for order in (-1, 1)))
        self.write("measures.csv", "quantity,value,uncertainty\nturns,40,\nresonance_x_hz,30,\n")
        found = scope.ScopeRun(self.directory)
        self.assertEqual((found.orders, found.directions, found.resonances), ([1.0, 2.0], ["x"], ["30"]))
        root = self.draw("scope")
        self.assertEqual(figures.over_each_other(root), [])
        both = "t_s,speed_hz,order,x_amplitude_m,x_phase_deg,y_amplitude_m,y_phase_deg\n"
        both += "".join(f"{k},{10 + k / 2},{order},{1e-5 / (1 + abs(k - 20))},-90,1e-6,0\n" for order in (1, 2) for k in range(40))
        self.write("bode.csv", both)
        self.write("measures.csv", "quantity,value,uncertainty\nturns,40,\nresonance_x_hz,19.381,\n")
        crowded = self.draw("scope")
        self.assertIn("2X, y", figures.words(crowded))
        self.assertEqual(figures.over_each_other(crowded), [])
        for word in ("amplitude (µm)", "phase of 1X (deg)", "1X, x", "2X, x", "resonance 30 Hz", "shaft speed (Hz)", "order"):
            self.assertIn(word, figures.words(root))
        self.assertEqual(figures.over_each_other(root), [])
