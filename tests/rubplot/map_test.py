import figures
from rubplot import map_axes
from rubplot.failure import Failure
from rubplot.pictures import map as picture

CONFIG = """\
title: Blower
rotor:
  kind: jeffcott
  mass_kg: 0.8
  natural_frequency_hz: 30
  damping_ratio: 0.02
stops:
  - kind: one_side
    angle_deg: 90
    clearance_m: 0.001
    stiffness_n_per_m: 2000000
sweep:
  {speed}
  whirl_ratio:
    {ratio}
"""
COLUMNS = "speed_hz,whirl_ratio,class,order,orbit,whirl,comb_spacing\n"


class Map(figures.FigureTest):
    def words(self, speed, ratio):
        self.write("config.yaml", CONFIG.format(speed=speed, ratio=ratio))
        self.write("map.csv", COLUMNS + "".join(
            f"{hz},{share},synchronous,1,complex,mixed,\n" for share in (0.01, 0.1, 1) for hz in (50, 100, 150)))
        root = self.draw("map", "--heading", "Rub domains", source="map.csv")
        self.assertEqual(figures.over_each_other(root), [])
        return figures.words(root)

    def test_a_map_in_hz_is_drawn_over_natural_frequencies(self):
        words = self.words("speed_hz:\n    values: [50, 100, 150]", "values: [0.01, 0.1, 1]")
        self.assertIn("shaft speed / natural frequency", words)
        self.assertIn("Blower: Rub domains", words)

    def test_a_heading_of_any_signs_leaves_the_picture_xml(self):
        self.write("config.yaml", CONFIG.format(speed="speed_hz:\n    values: [50, 100]", ratio="values: [0.1, 1]"))
        self.write("map.csv", COLUMNS + "".join(
            f"{hz},{share},synchronous,1,complex,mixed,\n" for share in (0.1, 1) for hz in (50, 100)))
        root = self.draw("map", "--heading", "a ]]> b <c> \ufffe d", source="map.csv")
        self.assertIn("Blower: a ]]> b <c> \ufffd d", figures.words(root))

    def test_the_units_and_the_scale_that_were_written_stand_at_the_axes(self):
        words = self.words("speed_rpm:\n    from: 3000\n    to: 9000\n    count: 3",
                           "from: 0.01\n    to: 1\n    count: 3\n    scale: log")
        self.assertIn("shaft speed (rpm)", words)
        self.assertIn("6000", words)
        # Decades are as far from each other as they are on such an axis.
        places = {text.text: text.y for text in figures.texts(self.root())}
        self.assertAlmostEqual(places["0.01"] - places["0.1"], places["0.1"] - places["1"], delta=2)

    def refined(self, painted):
        self.write("config.yaml", CONFIG.format(speed="speed_hz:\n    values: [50, 100, 150]\n  refine:\n    levels: 1",
                                                ratio="values: [0.1]"))
        self.write("map.csv", "# digest ab\n" + COLUMNS + "".join(
            f"{hz},0.1,synchronous,1,complex,mixed,\n" for hz in (50, 150)))
        if painted:
            self.write("painted.csv", painted)
        cells, _ = picture._in_si(map_axes.read_plane(self.path("map.csv")), None)
        return [(round(30 * cell.x), cell.kind) for cell in cells]

    def test_a_refined_map_is_drawn_with_the_cells_that_were_painted(self):
        rows = "".join(f"{hz},0.1,synchronous,1,circle,{computed}\n" for hz, computed in ((50, 1), (100, 0), (150, 1)))
        cells = self.refined("# digest ab\nspeed_hz,whirl_ratio,class,order,kind,computed\n" + rows)
        self.assertEqual(cells, [(50, "synchronous"), (100, "circle"), (150, "synchronous")])

    def test_a_refined_map_says_that_painted_cells_are_missing_or_of_another_map(self):
        with self.assertRaisesRegex(Failure, "painted.csv: is not there"):
            self.refined(None)
        with self.assertRaisesRegex(Failure, "painted.csv: is of another map"):
            self.refined("# digest cd\nspeed_hz,whirl_ratio,class,order,kind,computed\n")

    def root(self):
        return figures.xml.etree.ElementTree.parse(self.path("picture.svg")).getroot()
