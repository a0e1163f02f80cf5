import figures
from files import FileTest
from rubplot.pictures import ring_chart

CHART = """angle_deg,kind,speed_rpm,note
10,coupling_begin,500,"at 67 rad/s, without friction"
20,real_merger,600,"growing, divergence"
9.5,real_merger,700,growing
9.5,real_merger,800,growing
30,real_merger,700,decaying
"""


class Chart(FileTest):
    def test_onsets_by_kind_whatever_the_parameter_is_called(self):
        self.write("chart_onsets.csv", CHART)
        chart = ring_chart.read_chart(self.directory)
        self.assertEqual(chart.parameter, "angle_deg")
        self.assertEqual(chart.by_kind["coupling_begin"], ["10 500"])
        self.assertEqual(chart.by_kind["flutter_end"], [])
        self.assertEqual(chart.couplings, [9.5, 20])


class Drawn(figures.FigureTest):
    def test_axes_say_parameter_and_unit(self):
        self.write("chart_onsets.csv", CHART)
        self.write("config.yaml", "title: Test_rig\nchart:\n  parameter: angle_deg\n  over:\n    from: 0\n    to: 90\n    count: 10\n")
        words = figures.words(self.draw("ring-chart"))
        for text in ("angle (°)", "speed (rpm)", "coupling begins (µ = 0)", "Test_rig: Onsets of instability"):
            self.assertIn(text, words)
