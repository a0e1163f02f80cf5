import figures

CONFIG = """\
rotor:
  kind: rotor_kit
  sensors:
    - position_m: 0.05
      angle_deg: 0
    - position_m: 0.05
      angle_deg: 90
stops:
  - kind: one_side
    angle_deg: 90
    position_m: 0.05
    clearance_m: 0.0005
  - kind: annular
    position_m: 0.6
    clearance_m: 0.0003
  - kind: one_side
    angle_deg: -90
    position_m: 0.7
    clearance_m: 0.0004
gravity_m_per_s2: 0
response:
  window_revolutions: 4
"""
MOTION = "speed_hz,whirl_ratio,class,order,orbit,whirl,comb_spacing,start\n50,0.6,{},{},complex,mixed,,kick\n"


class Trace(figures.FigureTest):
    def setUp(self):
        super().setUp()
        self.write("config.yaml", CONFIG)
        self.write("motion.csv", MOTION.format("chaotic", ""))
        self.write("section.csv", "revolution,t_s,x_m,y_m,vx_m_per_s,vy_m_per_s\n" +
                   "".join(f"{k},{k / 50},1e-4,1e-3,0,2\n" for k in range(11)))
        self.write_trajectory(1e-3)
        self.write_spectrum([(1, 1e-3)])

    def write_trajectory(self, size_m):
        self.write("trajectory.csv", "t_s,x_m,y_m,gap_0_m,gap_1_m,gap_2_m\n" +
                   "".join(f"{k / 100},{size_m * (k % 3 - 1)},{size_m * (k % 5 - 2) / 2},1e-4,1e-4,2e-4\n" for k in range(20)))

    def write_spectrum(self, lines):
        self.write("spectrum.csv", "order,frequency_hz,amplitude_m\n" +
                   "".join(f"{order},{50 * order},{amplitude}\n" for order, amplitude in lines))

    def shapes(self, root):
        return sum(node.tag in (figures.SVG + "path", figures.SVG + "polygon") for node in root.iter())

    def test_only_walls_where_the_orbit_is_stand_around_it(self):
        root = self.draw("trace")
        title = next(text for text in figures.words(root) if text.startswith("chaotic"))
        self.assertIn("seen at 50 mm, stop 1 at 600 mm, stop 2 at 700 mm", title)
        self.assertIn("rotor at the stop", figures.words(root))
        self.write("config.yaml", CONFIG.replace("0.6", "0.05"))
        beside_a_ring = self.draw("trace")
        self.assertGreater(self.shapes(beside_a_ring), self.shapes(root))

    def test_names_of_lines_do_not_cover_each_other_however_far_the_spectrum_goes(self):
        for highest in (2, 3, 5, 8):
            with self.subTest(highest=highest):
                steps = [k / 8 for k in range(-8 * highest, 8 * highest + 1)]
                self.write_spectrum([(order, (10 + k if k % 2 else 1) * 1e-4) for k, order in enumerate(steps)])
                root = self.draw("trace")
                self.assertGreater(sum(text.endswith("X") for text in figures.words(root)), 3)
                self.assertEqual(figures.over_each_other(root), [])

    def test_a_small_motion_has_an_axis_of_short_numbers(self):
        for size_m, unit in ((3e-4, "mm"), (2.2e-5, "mm"), (7e-6, "µm"), (4e-9, "nm")):
            with self.subTest(size_m=size_m):
                self.write_trajectory(size_m)
                self.write_spectrum([(-1, 0.004 * size_m), (1, size_m)])
                root = self.draw("trace")
                self.assertEqual({"time (ms)", f"x ({unit})", f"amplitude ({unit})"} - set(figures.words(root)), set())
                self.assertEqual(figures.over_each_other(root), [])
