import re
from dataclasses import replace

from files import FileTest
from rubplot import trace_layout
from rubplot.failure import Failure

CONFIG = """\
rotor:
  natural_frequency_hz: 30
stops:
  - kind: one_side
    angle_deg: -90
    clearance_m: 0.001
    casing:
      mass_kg: 0.05
kick:
  duration_s: 0.005
gravity_m_per_s2: 0
response:
  window_revolutions: 4
"""
MOTION = "speed_hz,whirl_ratio,class,order,orbit,whirl,comb_spacing,start\n50,0.6,subharmonic,2,complex,mixed,,kick\n"
SECTION = "revolution,t_s,x_m,y_m,vx_m_per_s,vy_m_per_s\n" + "".join(f"{k},{k / 50},{k}e-4,1e-3,0,2\n" for k in range(11))
TRAJECTORY = "t_s,x_m,y_m,casing_0_x_m,casing_0_y_m\n" + "".join(f"{k / 100},{k},{-k},9,{k}e-6\n" for k in range(20))
SPECTRUM = "order,frequency_hz,amplitude_m\n-9,0,9\n0,0,0\n0.5,25,1e-3\n1,50,0\n"
PLAIN = trace_layout.Motion("50", "0.6", "chaotic", "", "complex", "mixed", "", False)


class LayOut(FileTest):
    def setUp(self):
        super().setUp()
        for name, text in (("config.yaml", CONFIG), ("motion.csv", MOTION), ("section.csv", SECTION),
                           ("trajectory.csv", TRAJECTORY), ("spectrum.csv", SPECTRUM)):
            self.write(name, text)

    def lay_out(self, revolutions=40):
        return trace_layout.lay_out(self.directory, revolutions)

    def test_assignments(self):
        self.assertEqual(
            self.lay_out().assignments,
            {
                "row_title": '"subharmonic 1/2: 50 Hz (3000 rpm) = 1.67 × natural frequency, whirl ratio 0.6"',
                "probed": 0,
                "from": 0,
                "to": 10,
                "speed_hz": "50",
                "order": "2",
                "kick_s": "0.005",
                "at_rest": 0,
                "in_state": 0,
                "moving_walls": '"4 -1 "',
                "elsewhere": '""',
                "levels": '"-1 "',
                "gravity": "0",
                "start_y_m": "1e-3",
                "start_vy_m_per_s": "2",
                "walls": '"6.123233995736766e-17 -1 1 "',
                "rings": '""',
                "per_metre": "1000",
                "unit": '"mm"',
                "comb_spacing": 0,
                "highest": 2,
            },
        )

    def test_curves(self):
        row = self.lay_out(-1)
        self.assertEqual(row.files["history"], ["0.18 18 -18 18e-6", "0.19 19 -19 19e-6"])
        # Two periods of the orbit, the window of the section.
        self.assertEqual(row.files["orbit"][0], "12 -12")
        self.assertEqual(row.files["section"][:2], ["7e-4 1e-3", "8e-4 1e-3"])
        self.assertEqual(row.files["spectrum"], ["0 0", "0.5 1e-3", "1 0"])
        self.assertEqual(list(row.label_lines(2)), ["0.5 1e-3 1/2X"])

    def test_readings_of_probes_that_see_x_and_y(self):
        self.write("sensors.csv", "t_s,speed_hz,shaft_angle_rad,sensor_0_m,sensor_1_m\n" +
                   "".join(f"{k / 1000},50,0,{k},{-k}\n" for k in range(200)))
        self.write("probe_spectrum.csv", "order,frequency_hz,amplitude_m\n-8.5,0,9\n0.5,25,1e-3\n")
        for kit, probed in (("kind: jeffcott", 1), ("kind: rotor_kit", 0),
                            ("kind: rotor_kit\n  sensors:\n    - angle_deg: 0\n    - angle_deg: 90", 1),
                            ("kind: rotor_kit\n  sensors:\n    - angle_deg: 45\n    - angle_deg: 135", 0)):
            self.write("config.yaml", CONFIG.replace("rotor:", "rotor:\n  " + kit))
            self.assertEqual(self.lay_out(-1).assignments["probed"], probed, kit)
        self.write("config.yaml", CONFIG.replace("rotor:", "rotor:\n  kind: jeffcott"))
        files = self.lay_out(-1).files
        self.assertEqual(files["probe_history"][0], "0.18 -180")
        # The orbit from revolution 6 on, 120 ms.
        self.assertEqual(files["probe_orbit"][0], "120 -120")
        self.assertEqual(files["probe_spectrum"], ["0.5 1e-3"])

    def test_a_run_that_started_in_contact_has_no_kick(self):
        self.write("motion.csv", MOTION.replace(",kick", ",contact"))
        row = self.lay_out().assignments
        self.assertEqual((row["kick_s"], row["at_rest"]), ("0", 1))

    def test_nothing_comes_before_a_given_state(self):
        self.write("motion.csv", MOTION.replace(",kick", ",state"))
        self.assertEqual(self.lay_out().assignments["in_state"], 1)
        self.assertEqual(self.lay_out().assignments["at_rest"], 0)

    def test_text_that_would_be_code_is_refused(self):
        for name, text in (
            ("motion.csv", MOTION.replace("subharmonic", 'x"; system("x")')),
            ("motion.csv", MOTION.replace("50,", "a[0],")),
            ("section.csv", SECTION.replace(",2\n", ",system(1)\n")),
            ("config.yaml", CONFIG.replace(": 4", ": a[0]")),
            ("config.yaml", CONFIG.replace("0.005", "1; system(2)")),
        ):
            before = self.read(name)
            self.write(name, text)
            with self.assertRaisesRegex(Failure, "is not allowed there"):
                self.lay_out()
            self.write(name, before)

    def test_a_missing_file_is_named(self):
        self.write("empty/config.yaml", "")
        with self.assertRaisesRegex(Failure, "cannot read .*empty/trajectory.csv"):
            trace_layout.lay_out(self.path("empty"), 40)


class Title(FileTest):
    def expect(self, title, natural_hz=None, **changes):
        self.assertEqual(trace_layout.title(replace(PLAIN, **changes), "50 Hz", natural_hz), title)

    def test_titles(self):
        self.expect("chaotic: 50 Hz, whirl ratio 0.6")
        self.expect("no contact: 50 Hz = 2 × natural frequency, whirl ratio 0.6", 25, name="non_contact")
        self.expect("synchronous circle: 50 Hz, whirl ratio 0.6", name="synchronous", order="1", orbit="circle")
        self.expect("chaotic: 50 Hz, no clearance left at rest", whirl_ratio="")

    def test_an_oval_is_not_called_synchronous(self):
        self.expect(
            "quasi-periodic oval, closed in the rotating frame, lines at 1 ± k 0.6124: 50 Hz, whirl ratio 0.6",
            name="quasi_periodic", orbit="oval", whirl="forward", comb_spacing="0.61239",
        )
        self.expect(
            "backward dry whip, lines at 1 ± k 2.686: 50 Hz, whirl ratio 0.6",
            name="quasi_periodic", whirl="backward", comb_spacing="2.6857",
        )


class Spans(FileTest):
    def spans(self, revolutions, first=0, last=100, **changes):
        found = trace_layout.spans(replace(PLAIN, **changes), first, last, 64, revolutions)
        return found.begin, found.end, found.orbit_from, found.section_from

    def test_spans(self):
        self.assertEqual(self.spans(40), (0, 40, 36, 37))
        self.assertEqual(self.spans(-20, order="3"), (80, 100, 94, 37))
        self.assertEqual(self.spans(40, first=90, comb_spacing="0.6"), (90, 100, 92, 37))
        self.assertEqual(self.spans(-20, first=90, last=100), (90, 100, 36, 37))
        self.assertEqual(self.spans(5, last=20), (0, 5, 0, 0))


class Checked(FileTest):
    def test_checked(self):
        self.assertEqual(trace_layout.checked("x", "12", re.compile("[0-9]+")), "12")
        with self.assertRaisesRegex(Failure, "x: '12a' is not allowed there"):
            trace_layout.checked("x", "12a", re.compile("[0-9]+"))
