"""The published domain maps."""

import argparse
import os
from dataclasses import dataclass

from rubplot.pictures import map as domain_map


@dataclass(frozen=True)
class MapFigure:
    stem: str
    heading: str

    def draw(self, name, sources, wanted):
        """Computes the map first where there is none."""
        source = wanted.map or os.path.join(sources.results, self.stem, "map.csv")
        if wanted.map is None and not os.path.exists(source):
            sources.run("rubsweep", self.stem, "--output", os.path.dirname(source))
        given = argparse.Namespace(source=source, heading=self.heading, fade=False, natural_frequency_hz=None)
        wanted.draw(domain_map.picture(given), sources.figure(name))


FIGURES = {
    "figure06": MapFigure("reference/figure06_one_side", "Figure 6: rub domains after a kick, stop on one side"),
    "figure09": MapFigure("reference/figure09_both_sides", "Figure 9: rub domains after a kick, stops on both sides"),
    "figure11": MapFigure("reference/figure11_annulus", "Figure 11: rub domains after a kick, centred annulus"),
    "figure12": MapFigure("reference/figure12_annulus_offset", "Figure 12: rub domains after a kick, annulus with offset"),
    "both_sides_unequal": MapFigure("reference/both_sides_unequal",
                                    "Rub domains after a kick, the lower stop farther away"),
    "set_a_one_side": MapFigure("benchmark/one_side", "Benchmark, set A: stop on one side"),
    "set_a_both_sides": MapFigure("benchmark/both_sides", "Benchmark, set A: stops on both sides"),
    "set_a_both_sides_unequal": MapFigure("benchmark/both_sides_unequal", "Benchmark, set A: the lower casing twice as stiff"),
    "set_d_annulus": MapFigure("benchmark/annulus", "Benchmark, set D: centred annulus"),
    "set_d_annulus_offset": MapFigure("benchmark/annulus_offset", "Benchmark, set D: annulus with offset"),
    "set_b_one_side": MapFigure("hard_case/one_side", "Hard case, set B: stop on one side"),
    "set_b_both_sides": MapFigure("hard_case/both_sides", "Hard case, set B: stops on both sides"),
    "set_b_both_sides_unequal": MapFigure("hard_case/both_sides_unequal", "Hard case, set B: the lower stop farther away"),
    "set_b_annulus": MapFigure("hard_case/annulus", "Hard case, set B: centred annulus"),
    "set_b_annulus_offset": MapFigure("hard_case/annulus_offset", "Hard case, set B: annulus with offset"),
}
BENCHMARKS = [name for name in FIGURES if name.startswith("set_")]
