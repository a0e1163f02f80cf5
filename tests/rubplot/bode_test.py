import figures
from rubplot.pictures import bode


class Bode(figures.FigureTest):
    def setUp(self):
        super().setUp()
        self.write("config.yaml", "title: Pump\nrotor:\n  sensors:\n    - position_m: 0.1\n      angle_deg: 45\n")
        self.write("identification.csv", "quantity,sensor,value\nresonance_frequency_hz,0,20.004\nlargest_amplitude_m,0,5e-6\n")
        self.write("bode.csv", "speed_hz,sensor_0_amplitude_m,sensor_0_phase_deg,sensor_1_amplitude_m,sensor_1_phase_deg\n" +
                   "10,1e-6,-300,1e-6,-5\n20,5e-6,-358,4e-6,-90\n30,2e-6,-2,2e-6,-175\n")

    def test_amplitude_in_a_unit_of_its_size_and_a_phase_that_does_not_jump(self):
        found = bode.Bode(self.directory)
        self.assertEqual(found.unit, "µm")
        self.assertEqual([line.split()[2] for line in found.lines(0)], ["-300", "-358", "-362"])
        self.assertEqual([line.split()[1] for line in found.lines(1)], ["1", "4", "2"])

    def test_the_picture_says_what_it_shows(self):
        root = self.draw("bode", "--heading", "Run-up")
        for word in ("Pump: Run-up", "1X amplitude (µm)", "phase (°)", "shaft speed (Hz)", "sensor 0, at 100 mm, 45°",
                     "sensor 1", "resonance 20 Hz", "rpm", "900", "1200"):
            self.assertIn(word, figures.words(root))
        self.assertEqual(figures.over_each_other(root), [])

    def test_rpm_and_mil_peak_to_peak_where_they_are_asked_for(self):
        root = self.draw("bode", "--speed-unit", "rpm", "--length-unit", "mil", "--peak-to-peak")
        for word in ("1X amplitude (mil peak to peak)", "shaft speed (rpm)", "resonance 1200 rpm"):
            self.assertIn(word, figures.words(root))
        self.assertNotIn("rpm", figures.words(root))
        self.assertEqual(figures.over_each_other(root), [])
