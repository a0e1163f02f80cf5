import figures
from files import FileTest
from rubplot.failure import Failure
from rubplot.pictures import work_precision

HEADER = "cell,method,stepper,contact,tolerance,microseconds_per_revolution,state_error,status\n"


class Chart(FileTest):
    def chart(self, rows):
        return work_precision.read_chart(self.write("t.csv", HEADER + rows))

    def test_blocks_by_cell_contact_stepper_and_method(self):
        chart = self.chart(
            "a,adaptive,dopri5,located,1e-4,20,1e-5,ok\n"
            "b,adaptive,dopri5,located,1e-4,30,1e-6,ok\n"
            "a,adaptive,dopri5,located,1e-5,40.5,1e-7,ok\n"
            "a,adaptive,dopri5,located,1e-9,,,step_limit\n"
            "a,exact,,located,,1.25,0,ok\n"
            "b,exact,,located,,1.25,1e-12,ok\n"
        )
        self.assertEqual(chart.titles, ["a", "b"])
        self.assertEqual(
            "".join(line + "\n" for line in work_precision.data_lines(chart)),
            "# 1_located_dopri5_adaptive\n20 1e-05\n40.5 1e-07\n\n\n# 2_located_dopri5_adaptive\n30 1e-06\n\n\n"
            "# 2_located_exact_exact\n1.25 1e-12\n\n\n# 2_smoothed_exact_exact\n1.25 1e-12\n\n\n",
        )
        settings = "".join(line + "\n" for line in work_precision.settings(chart))
        self.assertIn("array cell_title[2]\ncell_title[1] = 'a'\n", settings)
        self.assertIn("low_time = 0.625\nhigh_time = 81\nlow_error = 3.33333e-13\nhigh_error = 3e-05\n", settings)
        self.assertIn("known = ' 1_located_dopri5_adaptive 2_located_dopri5_adaptive ", settings)

    def test_nothing_to_draw(self):
        with self.assertRaisesRegex(Failure, "no run to draw"):
            self.chart("a,adaptive,dopri5,located,1e-4,,,step_limit\n")



class Drawn(figures.FigureTest):
    def test_captions_of_the_head_of_the_table(self):
        self.write("work_precision.csv", "# title Test_rig\n# author N. N.\n# note a note\n" + HEADER +
                   "75 Hz,adaptive,dopri5,located,1e-4,20,1e-5,ok\n75 Hz,exact,,located,,1.25,1e-12,ok\n")
        words = figures.words(self.draw("work-precision"))
        for text in ("Test_rig: Work against precision", "N. N.: a note", "processor time per revolution (µs)",
                     "error after 6 revolutions (clearance)", "exact, without a stepper"):
            self.assertIn(text, words)
