import unittest

from rubplot import heading

ONE_SIDE = {
    "rotor.mass_kg": "0.8",
    "rotor.natural_frequency_hz": "30",
    "rotor.damping_ratio": "0.02",
    "stops.0.kind": "one_side",
    "stops.0.clearance_m": "0.001",
    "stops.0.stiffness_n_per_m": "2000000",
    "stops.0.restitution": "0.7",
    "stops.0.casing.mass_kg": "0.05",
    "stops.0.casing.stiffness_n_per_m": "500000",
    "stops.0.casing.damping_ratio": "0.1",
    "kick.force_n": "200",
    "kick.duration_s": "0.005",
}


def lower_casing(stiffness):
    casing = {key.replace(".0.", ".1."): value for key, value in ONE_SIDE.items() if key.startswith("stops.0.")}
    return {**ONE_SIDE, **casing, "stops.1.casing.stiffness_n_per_m": stiffness}


class Heading(unittest.TestCase):
    def test_numbers_for_people(self):
        for value, text in ((2e6, "2×10^{6}"), (1.5e-7, "1.5×10^{-7}"), (30, "30"), (0.123456, "0.1235"), (1e5, "1×10^{5}")):
            self.assertEqual(heading.people_number(value), text)

    def test_one_stop(self):
        self.assertEqual(
            heading.text("Title", ONE_SIDE),
            "{/:Bold Title}\n"
            "{/*0.75 rotor 0.8 kg, 30 Hz, ζ = 0.02; clearance 1 mm, K = 2×10^{6} N/m, nominal e = 0.7}\n"
            "{/*0.75 casing 0.05 kg on 5×10^{5} N/m, ζ = 0.1; kick 200 N for 5 ms}",
        )

    def test_casings_are_named_in_turn_where_they_differ(self):
        self.assertIn("casing 0.05 kg on 5×10^{5} N/m, ζ = 0.1; ", heading.text("", lower_casing("500000")))
        self.assertIn("ζ = 0.1, and 0.05 kg on 1×10^{6} N/m", heading.text("", lower_casing("1000000")))

    def test_a_kit_without_kick_against_a_rigid_offset_stop(self):
        config = {
            "rotor.kind": "rotor_kit",
            "stops.0.kind": "annular",
            "stops.0.clearance_m": "0.001",
            "stops.0.hertz.design_force_n": "250",
            "stops.0.offset_m": "[0, 0.00025]",
            "stops.0.restitution_delivered": "0.6",
            "stops.0.casing": "rigid",
        }
        self.assertEqual(
            heading.text("T", config, 29.868).split("\n")[1:],
            [
                "{/*0.75 rotor kit, identified 29.87 Hz; clearance 1 mm, Hertz line contact at 250 N, "
                "offset [0, 0.25] mm, delivered e = 0.6}",
                "{/*0.75 casing rigid; no kick}",
            ],
        )
        self.assertIn("{/*0.75 rotor kit; ", heading.text("T", config))

    def test_what_the_picture_varies_is_no_number_of_the_heading(self):
        text = heading.text("", ONE_SIDE, varied=("kick.force_n",))
        self.assertIn("kick for 5 ms", text)
        swept = {**ONE_SIDE, "sweep.x.key": "stops.0.restitution", "sweep.y.keys": "[rotor.mass_kg, rotor.damping_ratio]",
                 "study.key": "kick.duration_s"}
        text = heading.text("", swept)
        self.assertIn("rotor 30 Hz; clearance 1 mm, K = 2×10^{6} N/m}", text)
        self.assertIn("kick 200 N}", text)
        self.assertNotIn("nominal", text)

    def test_title_author_and_note_of_the_configuration(self):
        config = {**ONE_SIDE, "title": "Pump_3 {new}", "author": '"A. Bé"', "note": '"first: line\\nsecond"'}
        lines = heading.text("Map", config).split("\n")
        self.assertEqual(lines[0], r"{/:Bold Pump\_3 \{new\}: Map}")
        self.assertEqual(lines[3], "{/*0.6 A. Bé: first: line}")
