import math

import figures
from rubplot.failure import Failure
from rubplot.pictures import identification

TABLE = "quantity,sensor,value\nmisfit,0,1\nnatural_frequency_hz,1,29.5\nnatural_frequency_hz,2,31\ndamping_ratio,1,0.03\n"


class Find(figures.FigureTest):
    def test_the_first_sensor_with_the_quantity(self):
        path = self.write("identification.csv", TABLE)
        self.assertEqual(identification.find(path, "natural_frequency_hz"), identification.Found(29.5, 1))
        with self.assertRaisesRegex(Failure, "identification.csv: no quantity 'mass'"):
            identification.find(path, "mass")

    def test_decay_and_run_up_are_drawn(self):
        self.write("free_response/identification.csv", TABLE)
        self.write("free_response/sensors.csv", "t_s,speed_hz,shaft_angle_rad,sensor_0_m,sensor_1_m\n" + "".join(
            f"{k / 1000},0,0,0,{1e-3 * math.cos(0.2 * k) * math.exp(-0.01 * k)}\n" for k in range(200)))
        self.write("run_up/identification.csv", "quantity,sensor,value\nresonance_frequency_hz,0,30\n")
        self.write("run_up/bode.csv", "speed_hz,sensor_0_amplitude_m,sensor_0_phase_deg,sensor_1_amplitude_m,sensor_1_phase_deg\n"
                   "20,1e-6,-5,1e-6,-6\n30,9e-6,-90,8e-6,-91\n40,2e-6,-170,2e-6,-171\n")
        words = figures.words(self.draw("identification"))
        self.assertIn("Rotor kit: natural frequency 29.500 Hz, damping ratio 0.0300; resonance 30.00 Hz", words)
        for label in ("time (s)", "displacement (mm)", "amplitude (µm)", "shaft speed (Hz)", "phase (deg)"):
            self.assertIn(label, words)
