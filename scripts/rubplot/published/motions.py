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
    "figure04": _motion("figure04_one_side", "Figure 4: rub persists after the kick", FROM_KICK, "78:0.1"),
    "figure05": _motion("figure05_one_side", "Figure 5: rub does not persist", FROM_KICK, "72:0.1"),
    "figure07": _motion("figure07_one_side", "Figure 7: against one stop", LAST, "69:0.1 120:0.1 156:0.1 207:0.1"),
    "figure08": _motion("figure08_both_sides", "Figure 8: between two stops", LAST, "90:0.5 135:0.1 195:0.02"),
    "figure10": _motion("figure10_annulus", "Figure 10: in a centred annulus", LAST, "90:0.55 225:0.15 225:0.55"),
    "figure13": _motion("figure13_annulus_offset", "Figure 13: in an annulus with offset", LAST,
                        "90:0.7 60:0.9 57:0.7 240:0.7"),
    "figure19": _motion("rotor_kit", "Figures 15 to 17, 19 to 21: rotor kit at 70 rev/s, exact, and as probes read it every "
                        "1 ms", LAST, "70:0.5", "--sample-s", "1e-3", "--noise-m", "2e-6"),
}
