import figures

CELLS = """# a {directory}/map.csv
# b other_b.csv
# tolerance 1e-04
speed_hz,whirl_ratio,kick.force_n,verdict,label_a,label_b
50,0.1,200,equal,non_contact,non_contact
75,0.1,200,classes_differ,non_contact,chaotic
100,0.1,200,numbers_differ,chaotic,chaotic
50,1,200,equal,non_contact,non_contact
75,1,200,sensitive,chaotic,non_contact
100,1,200,equal,non_contact,non_contact
"""


class Drawn(figures.FigureTest):
    def words(self, cells):
        self.write("cells.csv", cells.format(directory=self.directory))
        root = self.draw("compare", source="cells.csv")
        self.assertEqual(figures.over_each_other(root), [])
        return figures.words(root)

    def test_verdicts_are_counted_in_the_units_of_the_first_map(self):
        self.write("config.yaml", "sweep:\n  speed_rpm:\n    values: [3000, 4500, 6000]\n  whirl_ratio:\n    values: [0.1, 1]\n")
        words = self.words(CELLS)
        for text in ("Where two maps differ", "shaft speed (rpm)", "whirl ratio (quiet whirl / clearance)", "equal (3)",
                     "another class (1)", "other numbers (1)", "sensitive, not compared (1)", "5000"):
            self.assertIn(text, words)
        self.assertTrue(any("→ other_b.csv; numbers to a tolerance of 1e-04" in text for text in words))

    def test_without_the_configuration_units_are_si_and_equal_maps_are_called_so(self):
        words = self.words(CELLS.replace("classes_differ", "equal").replace("numbers_differ", "equal"))
        self.assertIn("Two maps that are equal", words)
        self.assertIn("shaft speed (Hz)", words)

    def test_no_verdict(self):
        path = self.write("cells.csv", CELLS.replace("sensitive", "odd"))
        code, _, said = figures.rubplot("compare", path)
        self.assertEqual(code, 3)
        self.assertIn("cells.csv: 'odd' is no verdict", said)
