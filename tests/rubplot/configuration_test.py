from files import FileTest
from rubplot import configuration

PRINTED = """\
rotor:
  kind: jeffcott
  mass_kg: 0.8
stops:
  - kind: annular
    offset_m: [0, 0.00025]
    friction:
      stribeck: [0, 0, 0, 0.1, 100, 0]
    casing:
      mass_kg: 0.05
  - kind: one_side
    casing: rigid
gravity_m_per_s2: 0
shaft:
  parts:
    - length_m: 1
      discs:
        - position_m: 2
        - position_m: 3
    - length_m: 4
output:
  directory: results/a: b
"""


class ReadConfiguration(FileTest):
    def read(self, text):
        return configuration.read_configuration(self.write("config.yaml", text))

    def test_names_every_value_by_its_path(self):
        self.assertEqual(
            self.read(PRINTED),
            {
                "rotor.kind": "jeffcott",
                "rotor.mass_kg": "0.8",
                "stops.0.kind": "annular",
                "stops.0.offset_m": "[0, 0.00025]",
                "stops.0.friction.stribeck": "[0, 0, 0, 0.1, 100, 0]",
                "stops.0.casing.mass_kg": "0.05",
                "stops.1.kind": "one_side",
                "stops.1.casing": "rigid",
                "gravity_m_per_s2": "0",
                "shaft.parts.0.length_m": "1",
                "shaft.parts.0.discs.0.position_m": "2",
                "shaft.parts.0.discs.1.position_m": "3",
                "shaft.parts.1.length_m": "4",
                "output.directory": "results/a: b",
            },
        )

    def test_takes_a_block_of_lines_as_one_value(self):
        self.assertEqual(
            self.read("rotor:\n  kind: matrices\n  mass: |\n    %%Matrix\n    1 1 2\n  modes: 3\nsweep: 1\n"),
            {"rotor.kind": "matrices", "rotor.mass": "%%Matrix\n1 1 2\n", "rotor.modes": "3", "sweep": "1"},
        )

    def test_refuses_what_no_program_writes(self):
        for text in ("a: 1\n  - 2\n", "just words\n", "\tb: 1\n", "A: 1\n"):
            with self.assertRaisesRegex(configuration.ConfigurationError, r"config.yaml:\d+: not as a program writes it"):
                self.read(text)

    def test_counts_stops(self):
        self.assertEqual(configuration.stop_count(self.read(PRINTED)), 2)


class Values(FileTest):
    def test_numbers_of_a_list(self):
        self.assertEqual(configuration.numbers("[0, 2.5e-4]"), [0, 2.5e-4])
        for text in ("rigid", "[0, system]", "[]"):
            with self.assertRaises(configuration.ConfigurationError):
                configuration.numbers(text)

    def test_a_number_is_no_word(self):
        self.assertEqual(configuration.number("1e-3"), 1e-3)
        with self.assertRaisesRegex(configuration.ConfigurationError, "'auto' is no number"):
            configuration.number("auto")

    def test_an_axis_is_listed_or_has_ends(self):
        spaced = {"a.from": "50", "a.to": "60", "a.count": "3"}
        self.assertEqual(configuration.axis(spaced, "a"), [50, 55, 60])
        self.assertEqual(configuration.axis({"a.values": "[1, 5]"}, "a"), [1, 5])
        self.assertEqual(configuration.axis({}, "a"), [])

    def test_a_text_is_a_word_or_quoted(self):
        self.assertEqual(configuration.text("pump"), "pump")
        self.assertEqual(configuration.text('"a \\"b\\" \\\\ \\n \\x09c"'), 'a "b" \\ \n \tc')
