"""Published figures, with programs that the test writes."""

import os
import unittest

import figures
from rubplot.published import figure, maps, motions, rings
from rubplot.published.sources import Sources

MAP = "speed_hz,whirl_ratio,class,order,orbit,whirl,comb_spacing\n75,0.4,chaotic,,,,\n90,0.4,chaotic,,,,\n105,0.4,chaotic,,,,\n"
CONFIG = "sweep:\n  speed_hz:\n    values: [75, 90, 105]\n  whirl_ratio:\n    values: [0.4]\n"
CONFIGS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../configs")


class Names(unittest.TestCase):
    def test_numbers_and_names_in_words(self):
        self.assertEqual(figure.find("6"), ["figure06"])
        self.assertEqual(figure.find("06"), ["figure06"])
        self.assertEqual(figure.find("ring-03"), ["ring_figure03"])
        self.assertEqual(figure.find("set_a-one-side"), ["set_a_one_side"])
        self.assertEqual(len(figure.find("benchmarks")), 10)
        self.assertEqual(len(figure.find("ring")), 18)
        self.assertEqual(figure.find("all"), [*(f"figure{n:02}" for n in (*range(4, 14), 19)), "both_sides_unequal"])

    def test_every_figure_has_its_configuration(self):
        stems = [one.stem for one in (*maps.FIGURES.values(), *motions.FIGURES.values())]
        for one in rings.FIGURES.values():
            stems += [run.stem for run in one.runs] if hasattr(one, "runs") else [one.stem]
        for stem in stems:
            self.assertTrue(os.path.exists(Sources(configs=CONFIGS).config(stem)), stem)


class Computed(figures.FigureTest):
    def program(self, name, text):
        os.chmod(self.write(f"bin/{name}", "#!/bin/sh\n" + text), 0o755)

    def figure(self, *arguments):
        return figures.rubplot("figure", *arguments, "--programs", self.path("bin"), "--results", self.path("results"))

    def test_a_map_is_computed_where_it_is_not_there(self):
        self.program("rubsweep", f"mkdir -p $3\nprintf '{CONFIG}' >$3/config.yaml\n"
                     f"cat >$3/map.csv <<END\n{figures.sealed(MAP)}END\nexit 4\n")
        self.assertEqual(self.figure("06"), (0, "", ""))
        self.assertEqual(sorted(os.listdir(self.path("results/figures"))), ["figure06.png", "figure06.svg"])
        self.program("rubsweep", "exit 1\n")
        self.assertEqual(self.figure("6", "--output", self.path("mine.pdf")), (0, "", ""))
        self.assertTrue(os.path.getsize(self.path("mine.pdf")) > 1000)
        code, _, said = self.figure("09")
        self.assertEqual(code, 3)
        self.assertIn("rubsweep ended with 1: ", said)

    def test_a_program_and_a_configuration_that_are_not_there_are_named(self):
        code, _, said = self.figure("06")
        self.assertEqual(code, 3)
        self.assertIn(f"there is no {self.path('bin/rubsweep')}", said)
        self.program("ringstab", "exit 0\n")
        code, _, said = self.figure("ring-03", "--configs", self.path("none"))
        self.assertEqual(code, 3)
        self.assertIn("none/ring/figure03.yaml: published figures need the sources of rubsweep, or --configs DIR", said)

    def test_panels_of_a_ring(self):
        self.program("ringstab", "mkdir -p $3\nprintf 'speed_rpm,mode,real_per_s,imaginary_rad_per_s\\n0,ring forward,1,10\\n"
                     "500,ring forward,1,15\\n1000,ring forward,2,20\\n' >$3/eigenvalues.csv\nprintf 'kind,speed_rpm\\n' >$3/onsets.csv\n")
        code, _, _ = self.figure("ring-14", "--formats", "svg")
        self.assertEqual(code, 0)
        with open(self.path("results/figures/ring_figure14.svg"), encoding="utf-8") as file:
            self.assertIn("Two unlike spring-masses", file.read())
