import unittest

from rubplot import shown_units


class Axes(unittest.TestCase):
    def test_si_units_stay(self):
        config = {"sweep.speed_hz.values": "[10, 20]", "sweep.whirl_ratio.from": "0.1", "sweep.whirl_ratio.scale": "log"}
        self.assertEqual(shown_units.axis(config, "speed_hz", 20), shown_units.Axis("shaft speed (Hz)"))
        self.assertEqual(shown_units.axis(config, "whirl_ratio"),
                         shown_units.Axis("whirl ratio (quiet whirl / clearance)", 1, True))
        self.assertEqual(shown_units.speed_text(config, 12.5), "12.5 Hz (750 rpm)")

    def test_what_was_written_in_other_units_comes_back_so(self):
        config = {"sweep.speed_rpm.from": "3000", "sweep.speed_rpm.to": "12000", "sweep.speed_rpm.scale": "log",
                  "sweep.unbalance_g_mm.values": "[0, 50, 200]"}
        self.assertEqual(shown_units.axis(config, "speed_hz"), shown_units.Axis("shaft speed (rpm)", 60, True))
        self.assertEqual(shown_units.axis(config, "eccentricity_m", 1e-4), shown_units.Axis("unbalance (g mm)", 2e6))
        # Without a map to compare with it stays a length, but where one disc is all the mass.
        self.assertEqual(shown_units.axis(config, "eccentricity_m").label, "eccentricity (m)")
        self.assertEqual(shown_units.axis(config | {"rotor.mass_kg": "0.8"}, "eccentricity_m"),
                         shown_units.Axis("unbalance (g mm)", 8e5))
        self.assertEqual(shown_units.speed_text(config, 50), "3000 rpm")

    def test_a_grade_and_an_axis_over_keys(self):
        config = {"sweep.balance_grade_mm_per_s.from": "1", "sweep.balance_grade_mm_per_s.to": "6.3",
                  "sweep.x.key": "kick.force_n", "sweep.x.scale": "log"}
        self.assertAlmostEqual(shown_units.axis(config, "eccentricity_m", 2e-5).factor, 315000)
        self.assertEqual(shown_units.axis(config, "kick.force_n"), shown_units.Axis("kick.force_n", 1, True))

    def test_a_unit_that_is_asked_for_is_shown_whatever_was_written(self):
        written = {"sweep.speed_rpm.from": "3000", "sweep.speed_rpm.to": "12000", "sweep.speed_rpm.scale": "log"}
        with shown_units.chosen(shown_units.Choice(speed="hz")):
            self.assertEqual(shown_units.axis(written, "speed_hz"), shown_units.Axis("shaft speed (Hz)", 1, True))
            self.assertEqual(shown_units.speed_text(written, 50), "50 Hz (3000 rpm)")
        with shown_units.chosen(shown_units.Choice(speed="rpm")):
            self.assertEqual(shown_units.axis({}, "speed_hz"), shown_units.Axis("shaft speed (rpm)", 60))
            self.assertEqual(shown_units.axis({}, "whirl_ratio").factor, 1)
            self.assertEqual(shown_units.speed_text({}, 50), "3000 rpm")
        self.assertEqual(shown_units.speed_text({}, 50), "50 Hz (3000 rpm)")

    def test_lengths_and_amplitudes_in_the_unit_that_is_asked_for(self):
        self.assertEqual(shown_units.of_length(1e-6), (1e6, "µm"))
        self.assertEqual(shown_units.millimetres(), (1e3, "mm"))
        with shown_units.chosen(shown_units.Choice(length="mil", peak_to_peak=True)):
            factor, word = shown_units.of_amplitude(12.7e-6)
            self.assertAlmostEqual(12.7e-6 * factor, 1)
            self.assertEqual(word, "mil peak to peak")
            self.assertAlmostEqual(25.4e-6 * shown_units.millimetres()[0], 1)
        # Twice the size may want the next unit.
        with shown_units.chosen(shown_units.Choice(peak_to_peak=True)):
            self.assertEqual(shown_units.of_amplitude(1.5e-5), (2e3, "mm peak to peak"))


if __name__ == "__main__":
    unittest.main()
