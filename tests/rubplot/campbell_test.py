import figures

import unittest

from rubplot.pictures import campbell


def point(mode, speed, frequency, whirl="forward"):
    return {"mode": float(mode), "speed_hz": float(speed), "frequency_hz": float(frequency), "whirl": whirl}


class Curves(unittest.TestCase):
    def test_a_stretch_ends_where_the_next_one_begins(self):
        rows = [point(1, 0, 30, "backward"), point(1, 10, 29, "mixed"), point(2, 0, 30)]
        self.assertEqual(list(campbell.curve_lines(rows)),
                         ["0 30 1", "10 29 1", "", "10 29 2", "", "0 30 0", ""])


class Labels(unittest.TestCase):
    def test_modes_that_end_at_one_height_share_a_text(self):
        rows = [point(1, 0, 30), point(1, 100, 30), point(2, 0, 31), point(2, 100, 31), point(3, 0, 80), point(3, 100, 90),
                point(4, 0, 150), point(4, 100, 160)]
        names = list(campbell.name_lines(rows, 150))
        self.assertEqual(len(names), 2)  # the fourth ends above the picture
        self.assertIn("'1,2' at first 100, first 30.5", names[0])
        self.assertIn("'3' at first 100, first 90", names[1])

    def test_modes_that_end_at_other_speeds_have_their_own_names_above_the_axis(self):
        rows = [point(1, 0, 2), point(1, 100, 1), point(2, 0, 2), point(2, 60, 0.5), point(3, 0, 1), point(3, 100, 0)]
        self.assertEqual([label.split(" left")[0] for label in campbell.name_lines(rows, 100)],
                         ["set label '2' at first 60, first 3", "set label '3,1' at first 100, first 3"])

    def test_close_speeds_get_one_label_and_near_ones_stand_on_different_sides(self):
        rows = [{"speed_hz": speed} for speed in (5, 50, 50.1, 56, 90)]
        labels = list(campbell.label_lines(rows, 100))
        self.assertEqual(len(labels), 4)
        self.assertIn("'5' at first 5, first 5 left offset 0.3, 0.9", labels[0])
        self.assertIn("'50–50.1' at first 50.0", labels[1], "no speed that is none of the two")
        self.assertIn("left offset 0.8, -0.8", labels[1])
        self.assertIn("right offset -0.8, 0.8", labels[2])
        self.assertIn("right offset -0.8, 0.8", labels[3])


    def test_a_label_whose_place_is_taken_goes_to_the_other_side(self):
        rows = [{"speed_hz": speed} for speed in (63.92, 77.79, 84.86, 92.7, 97.05)]
        labels = list(campbell.label_lines(rows, 140))
        self.assertIn("left offset 0.8, -0.8", labels[1])
        self.assertIn("'84.86'", labels[2])
        self.assertIn("right offset -0.8, 0.8", labels[2])

    def test_a_label_stands_beside_the_curves(self):
        rows = [{"speed_hz": 60.0}]
        self.assertIn("right offset -0.8, 0.8", next(campbell.label_lines(rows, 100)))
        self.assertIn("right offset -0.8, 0.8", next(campbell.label_lines(rows, 100, curves=[point(1, 0, 9), point(1, 100, 9)])))
        crossing = [point(1, 57, 50), point(1, 58, 90)]
        self.assertIn("left offset 0.8, -0.8", next(campbell.label_lines(rows, 100, curves=crossing)))

    def test_labels_of_an_axis_that_begins_late_stand_in_the_picture(self):
        self.assertEqual(campbell.place_of_1x([], 180, 100), 100 + 0.94 * 80)
        self.assertEqual(campbell.place_of_1x([{"speed_hz": 178.0}], 180, 100), 100 + 0.85 * 80)
        self.assertAlmostEqual(campbell.place_of_2x(180, 270, 100), 0.47 * 270)
        self.assertIsNone(campbell.place_of_2x(180, 270, 125))
        flat = [point(1, speed, 100 + 0.94 * 80 + campbell.ABOVE * 270) for speed in range(100, 181)]
        blocked = campbell.crossed(flat, 270, lambda speed: speed + campbell.ABOVE * 270)
        self.assertEqual(campbell.place_of_1x([], 180, 100, blocked), 100 + 0.85 * 80)
        labels = list(campbell.label_lines([{"speed_hz": 103.0}, {"speed_hz": 150.0}], 180, 1, 100, 270))
        self.assertIn("left offset 0.3, 0.9", labels[0])
        self.assertIn("right offset -0.8, 0.8", labels[1])


class Shapes(unittest.TestCase):
    @staticmethod
    def shape(mode, whirl, x, y):
        return [{"mode": float(mode), "whirl": whirl, "frequency_hz": 30.0, "position_m": 0.1 * i,
                 "x_real": a, "x_imag": 0.0, "y_real": b, "y_imag": 0.0} for i, (a, b) in enumerate(zip(x, y))]

    def test_backward_partners_and_discs_without_a_shaft_are_left_out(self):
        rows = self.shape(1, "backward", (0, 1), (0, 0)) + self.shape(2, "forward", (0, 1), (0, 0))
        self.assertEqual([number for number, _ in campbell.shown_shapes(rows)], [2])
        self.assertEqual(campbell.shown_shapes(self.shape(2, "forward", (1,), (0,))), [])

    def test_the_plane_of_the_larger_deflection_is_drawn(self):
        shown = campbell.shown_shapes(self.shape(1, "mixed", (0.1, 0.2), (0.5, 1)))
        lines = list(campbell.shape_lines(shown))
        self.assertEqual(lines[0], '"mode 1, 30 Hz"')
        self.assertEqual([line.split()[1] for line in lines[1:3]], ["0.5", "1"])

    def test_what_stands_on_the_shaft(self):
        config = {"rotor.discs.0.position_m": "0.25", "rotor.supports.0.position_m": "0", "stops.0.position_m": "0.5"}
        self.assertEqual(list(campbell.shaft_lines(config)), ["250 0", "0 1", "500 2"])


class Shaft(figures.FigureTest):
    def draw_shaft(self, positions):
        self.write("config.yaml", "rotor:\n  supports:\n    - position_m: 0\n    - position_m: %s\n" % positions[-1])
        self.write("campbell.csv", "mode,speed_hz,frequency_hz,whirl\n" +
                   "".join(f"1,{speed},25,forward\n" for speed in (0, 15, 30)))
        self.write("critical_speeds.csv", "mode,speed_hz,whirl\n1,25,forward\n")
        self.write("mode_shapes.csv", "mode,frequency_hz,whirl,position_m,x_real,y_real,x_imag,y_imag\n" +
                   "".join(f"1,25,forward,{place},{place / positions[-1]},0,0,0\n" for place in positions))
        return self.draw("campbell")

    def test_the_whole_shaft_is_shown_however_fast_it_turns(self):
        # The axis of the shaft is longer, in mm, than that of the speeds in Hz.
        root = self.draw_shaft([0.0, 0.4, 0.8, 1.2])
        words = figures.words(root)
        self.assertEqual(figures.over_each_other(root), [])
        for label in ("place along the shaft (mm)", "shaft speed (Hz)", "whirl frequency (Hz)"):
            self.assertIn(label, words)
        self.assertIn("1200", words)
        self.assertIn("0", words)

    def test_places_along_a_long_shaft_are_numbered(self):
        for longest, places in ((1.6, ("500", "1000", "1500")), (7.0, ("2000", "4000", "6000"))):
            root = self.draw_shaft([longest * part / 4 for part in range(5)])
            self.assertEqual(figures.over_each_other(root), [])
            for place in places:
                self.assertIn(place, figures.words(root))

    def test_a_diagram_without_a_critical_speed_is_drawn_in_silence(self):
        self.write("config.yaml", "rotor:\n  kind: jeffcott\n")
        self.write("campbell.csv", "mode,speed_hz,frequency_hz,whirl\n" + "".join(f"1,{speed},25,forward\n" for speed in (5, 10)))
        self.write("critical_speeds.csv", "mode,speed_hz,whirl\n")
        self.write("mode_shapes.csv", "mode,frequency_hz,whirl,position_m,x_real,y_real,x_imag,y_imag\n")
        self.assertNotIn("critical speed", figures.words(self.draw("campbell")))

    def test_lock_speeds_are_marked_and_named(self):
        self.write("config.yaml", "rotor:\n  kind: jeffcott\n")
        self.write("campbell.csv", "mode,speed_hz,frequency_hz,whirl\n" + "".join(
            f"{mode},{speed},25,{whirl}\n" for mode, whirl in ((1, "backward"), (2, "forward")) for speed in (0, 50, 100)))
        self.write("critical_speeds.csv", "mode,speed_hz,whirl\n2,25,forward\n")
        self.write("mode_shapes.csv", "mode,frequency_hz,whirl,position_m,x_real,y_real,x_imag,y_imag\n")
        self.write("lock_speeds.csv", "speed_hz,p,first_mode,q,second_mode\n50,3,2,1,1\n75,2,2,1,1\n")
        root = self.draw("campbell")
        self.assertIn("shaft speed (Hz), ◇ lock speed", figures.words(root))
        self.assertEqual(figures.over_each_other(root), [])
        labels = list(campbell.lock_lines([50.0, 75.0], 100, 60))
        self.assertEqual(len(labels), 2)
        self.assertIn("at first 4500, first 1.2 point", labels[1])

    def test_no_text_stands_over_another_wherever_the_critical_speeds_are(self):
        for speeds in ((28.5,), (28, 29.5), (3, 15, 27.9), (14, 14.6, 15.2, 15.9), (26.2, 27, 27.8, 28.6, 29.4), (1, 1.5, 2)):
            with self.subTest(speeds=speeds):
                self.write("config.yaml", "rotor:\n  kind: jeffcott\n")
                self.write("campbell.csv", "mode,speed_hz,frequency_hz,whirl\n" + "".join(
                    f"{mode},{speed},{frequency},forward\n" for mode, frequency in enumerate(speeds, 1) for speed in (0, 15, 30)))
                self.write("critical_speeds.csv", "mode,speed_hz,whirl\n" +
                           "".join(f"{mode},{speed},forward\n" for mode, speed in enumerate(speeds, 1)))
                self.write("mode_shapes.csv", "mode,frequency_hz,whirl,position_m,x_real,y_real,x_imag,y_imag\n")
                self.assertEqual(figures.over_each_other(self.draw("campbell")), [])
