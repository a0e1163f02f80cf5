import figures


class Shaft(figures.FigureTest):
    def test_the_whole_shaft_is_shown_however_fast_it_turns(self):
        # The axis of the shaft is longer, in mm, than that of the speeds in Hz.
        positions = [0.0, 0.4, 0.8, 1.2]
        self.write("config.yaml", "rotor:\n  supports:\n    - position_m: 0\n    - position_m: 1.2\n")
        self.write("campbell.csv", "mode,speed_hz,frequency_hz,whirl\n" +
                   "".join(f"1,{speed},25,forward\n" for speed in (0, 15, 30)))
        self.write("critical_speeds.csv", "mode,speed_hz,whirl\n1,25,forward\n")
        self.write("mode_shapes.csv", "mode,frequency_hz,whirl,position_m,x_real,y_real,x_imag,y_imag\n" +
                   "".join(f"1,25,forward,{place},{place / 1.2},0,0,0\n" for place in positions))
        root = self.draw("draw_campbell.py", ".", "Campbell diagram")
        words = figures.words(root)
        self.assertEqual(figures.over_each_other(root), [])
        self.assertIn("place along the shaft (mm)", words)
        self.assertIn("1200", words)
        self.assertIn("0", words)

    def test_no_text_stands_over_another_wherever_the_critical_speeds_are(self):
        for speeds in ((28.5,), (28, 29.5), (3, 15, 27.9)):
            with self.subTest(speeds=speeds):
                self.write("config.yaml", "rotor:\n  kind: jeffcott\n")
                self.write("campbell.csv", "mode,speed_hz,frequency_hz,whirl\n" + "".join(
                    f"{mode},{speed},{frequency},forward\n" for mode, frequency in enumerate(speeds, 1) for speed in (0, 15, 30)))
                self.write("critical_speeds.csv", "mode,speed_hz,whirl\n" +
                           "".join(f"{mode},{speed},forward\n" for mode, speed in enumerate(speeds, 1)))
                self.write("mode_shapes.csv", "mode,frequency_hz,whirl,position_m,x_real,y_real,x_imag,y_imag\n")
                self.assertEqual(figures.over_each_other(self.draw("draw_campbell.py", ".", "Campbell diagram")), [])
