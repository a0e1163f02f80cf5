"""The published motions: single cells, each a row of time history, orbit and full spectrum."""

import argparse
import os
from dataclasses import dataclass
from typing import Tuple

from rubplot.pictures import trace

FROM_KICK, LAST = 40, -20  # revolutions of the time history


@dataclass(frozen=True)
class MotionFigure:
    """`cells` are pairs of speed in Hz and whirl ratio; `more` are further options of rubtrace."""

    stem: str
    heading: str
    revolutions: int
    cells: Tuple[Tuple[str, str], ...]
    more: Tuple[str, ...] = ()

    def draw(self, name, sources, wanted):
        traces = [self._trace(name, sources, *cell) for cell in self.cells]
        given = argparse.Namespace(source=traces, heading=self.heading, revolutions=self.revolutions)
        wanted.draw(trace.picture(given), sources.figure(name))

    def _trace(self, name, sources, speed_hz, whirl_ratio):
        # The orbit needs a window at the end of the run; only a history from the kick on needs all of it.
        span = ("--last-revolutions", "128") if self.revolutions < 0 else ("--revolutions", "600")
        directory = os.path.join(sources.results, f"{name}_trace", f"{self.stem}_{speed_hz}_hz_{whirl_ratio}")
        cell = ("--speed-hz", speed_hz, "--whirl-ratio", whirl_ratio)
        sources.run("rubtrace", self.stem, *cell, *span, *self.more, "--output", directory)
        return directory


def cells(text):
    """'75:0.3 90:0.4' as pairs."""
    return tuple(tuple(cell.split(":")) for cell in text.split())


def _motion(stem, heading, revolutions, text, *more):
    return MotionFigure(f"reference/{stem}", heading, revolutions, cells(text), more)


FIGURES = {
    "figure04": _motion("figure04_one_side", "Figure 4: rub persists after the kick", FROM_KICK, "93:0.1"),
    "figure05": _motion("figure05_one_side", "Figure 5: rub does not persist", FROM_KICK, "84:0.1"),
    "figure07": _motion("figure07_one_side", "Figure 7: against one stop", LAST, "63:0.12 96:0.1 126:0.1 186:0.12"),
    "figure08": _motion("figure08_both_sides", "Figure 8: between two stops", LAST, "90:0.8 105:0.12 180:0.07"),
    "figure10": _motion("figure10_annulus", "Figure 10: in a centred annulus", LAST, "90:0.54 145:0.24 225:0.3"),
    "figure13": _motion("figure13_annulus_offset", "Figure 13: in an annulus with offset", LAST,
                        "120:0.72 55:0.72 130:0.08 215:0.4"),
    "figure19": _motion("rotor_kit", "Figures 15 to 17, 19 to 21: rotor kit at 70 rev/s, exact, and as probes read it every "
                        "1 ms", LAST, "70:0.5", "--sample-s", "1e-3", "--noise-m", "2e-6"),
}
