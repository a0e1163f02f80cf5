import unittest

import figures
from files import FileTest
from rubplot.failure import Failure
from rubplot.pictures import basin

CONFIG = """rotor:
  kind: jeffcott
stops:
  - kind: one_side
    angle_deg: {angle}
    clearance_m: 0.001
"""
SLICE = """# comment
{columns},attractor,label,status
-0.001,0,1,subharmonic 1/2,ok
0.001,0,2,non_contact,ok
-0.001,0.5,,failed,step_limit
0.001,0.5,3,subharmonic 1/2,ok
"""
ATTRACTORS = """attractor,label,starts,share,peak_displacement_m
1,subharmonic 1/2,1,0.25,0.00186
2,non_contact,1,0.25,0.0002
3,subharmonic 1/2,1,0.25,0.0024
"""


class SliceTest(FileTest):
    def slice_of(self, columns="x_m,casing0_vy_m_per_s", angle=90, table=SLICE, attractors=ATTRACTORS):
        self.write("config.yaml", CONFIG.format(angle=angle))
        self.write("slice.csv", table.format(columns=columns))
        self.write("attractors.csv", attractors)
        return basin.Slice(self.directory)

    def test_boxes_in_mm_and_m_per_s(self):
        self.assertEqual(
            list(basin.box_lines(self.slice_of())),
            ["-1 0 -2 0 -0.25 0.25 1", "1 0 0 2 -0.25 0.25 2", "-1 0.5 -2 0 0.25 0.75 0", "1 0.5 0 2 0.25 0.75 3"],
        )

    def test_keys_keep_their_numbers(self):
        self.assertEqual(
            next(basin.box_lines(self.slice_of("kick.force_n,kick.angle_deg"))), "-0.001 0 -0.002 0 -0.25 0.25 1"
        )

    def test_attractors_of_one_kind_have_ranks(self):
        found = self.slice_of().attractors
        self.assertEqual([(a.kind, a.rank) for a in found], [("subharmonic_2", 0), ("non_contact", 0), ("subharmonic_2", 1)])
        self.assertEqual(found[0].legend, "subharmonic 1/2, 1.86 mm: 25.0 %")
        self.assertEqual(found[1].legend, ": 25.0 %")

    def test_what_the_legend_has_no_room_for(self):
        many = SLICE.replace("3,subharmonic", "30,subharmonic")
        self.assertEqual(self.slice_of(table=many).numbers(), [1, 2, 0, basin.MOST_NAMED + 1])

    def test_the_wall_where_it_crosses_the_plane(self):
        self.assertIsNone(self.slice_of().wall())
        self.assertEqual(self.slice_of("vx_m_per_s,y_m").wall(), (1, 1))
        self.assertEqual(self.slice_of("y_m,x_m", angle=-90).wall(), (0, -1))
        self.assertEqual(self.slice_of("x_m,y_m", angle=180).wall(), (0, -1))
        self.assertIsNone(self.slice_of("x_m,y_m", angle=45).wall())

    def test_a_label_is_no_text_of_its_own(self):
        for label in ("subharmonic 1/2|x", "subharmonic 1/", "subharmonic 1/2; x"):
            with self.assertRaisesRegex(Failure, "no motion"):
                self.slice_of(attractors=ATTRACTORS.replace("1,subharmonic 1/2", f"1,{label}"))

    def test_refuses_what_rubbasin_did_not_write(self):
        with self.assertRaisesRegex(Failure, "not two numbers of a start"):
            self.slice_of("x_m,y_m,vx_m_per_s", table=SLICE.replace("-0.001,0,1", "-0.001,0,0,1").split("0.001,0,2")[0])
        with self.assertRaisesRegex(Failure, "no kind of motion"):
            self.slice_of(attractors=ATTRACTORS.replace("non_contact", "sub; system('ls')"))


class Drawn(figures.FigureTest):
    def test_attractors_and_axes_are_named_with_their_units(self):
        self.write("config.yaml", CONFIG.format(angle=90))
        self.write("slice.csv", SLICE.format(columns="x_m,vy_m_per_s"))
        self.write("attractors.csv", ATTRACTORS)
        root = self.draw("basin")
        words = figures.words(root)
        for text in ("displacement x of the rotor (mm)", "velocity y of the rotor (m/s)", "subharmonic 1/2, 1.86 mm: 25.0 %"):
            self.assertIn(text, words)
        self.assertEqual(figures.over_each_other(root), [])


class LabelTest(unittest.TestCase):
    def test_axes_say_body_and_unit(self):
        self.assertEqual(basin.axis_label("x_m"), "displacement x of the rotor (mm)")
        self.assertEqual(basin.axis_label("vy_m_per_s"), "velocity y of the rotor (m/s)")
        self.assertEqual(basin.axis_label("casing1_vx_m_per_s"), "velocity x of the casing of stop 1 (m/s)")
        self.assertEqual(basin.axis_label("kick.force_n"), r"kick.force\_n")

    def test_kinds_are_those_of_maps(self):
        self.assertEqual(basin.kind_of("subharmonic 1/3"), "subharmonic_3")
        self.assertEqual(basin.kind_of("subharmonic 1/24"), "subharmonic_8")
        self.assertEqual(basin.kind_of("quasi_periodic"), "quasi_periodic")


if __name__ == "__main__":
    unittest.main()
