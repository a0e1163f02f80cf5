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
    "figure06": MapFigure("figure06_one_side", "Rub domains after a kick, stop on one side"),
    "figure09": MapFigure("figure09_both_sides", "Rub domains after a kick, stops on both sides"),
    "figure11": MapFigure("figure11_annulus", "Rub domains after a kick, centred annulus"),
    "figure12": MapFigure("figure12_annulus_offset", "Rub domains after a kick, annulus with offset"),
    "both_sides_unequal": MapFigure("both_sides_unequal", "Rub domains after a kick, unequal casings on both sides"),
}
