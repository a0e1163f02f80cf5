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


def _reference(stem, what, revolutions, text):
    return MotionFigure(f"reference/{stem}", f"Reference machine: {what}", revolutions, cells(text))


FIGURES = {
    "figure04": MotionFigure("figure06_one_side", "Rub persists after the kick", FROM_KICK, cells("75:0.3")),
    "figure05": MotionFigure("figure06_one_side", "Rub dies out after the kick", FROM_KICK, cells("90:0.3")),
    "figure07": MotionFigure("figure06_one_side", "Subharmonic motions against one stop", LAST,
                             cells("72:0.15 111:0.15 150:0.15 186:0.15")),
    "figure08": MotionFigure("figure09_both_sides", "Motions between stops on both sides", LAST,
                             cells("75:0.4 180:0.15 219:0.12")),
    "figure10": MotionFigure("figure11_annulus", "Motions in a centred annulus", LAST,
                             cells("60:0.8 99:0.45 180:0.8 210:0.6")),
    "figure13": MotionFigure("figure12_annulus_offset", "Motions in an annulus with offset", LAST,
                             cells("60:0.8 66:0.4 99:0.75 210:0.8")),
}
REFERENCE = {
    "reference_figure04": _reference("figure04_one_side", "rub persists after the kick", FROM_KICK, "78:0.1"),
    "reference_figure05": _reference("figure05_one_side", "rub does not persist", FROM_KICK, "72:0.1"),
    "reference_figure07": _reference("figure07_one_side", "against one stop", LAST, "69:0.1 120:0.1 156:0.1 207:0.1"),
    "reference_figure08": _reference("figure08_both_sides", "between two stops", LAST, "90:0.5 135:0.1 195:0.02"),
    "reference_figure10": _reference("figure10_annulus", "in a centred annulus", LAST, "90:0.55 225:0.15 225:0.55"),
    "reference_figure13": _reference("figure13_annulus_offset", "in an annulus with offset", LAST,
                                     "90:0.7 60:0.9 57:0.7 240:0.7"),
    "reference_rotor_kit": MotionFigure(
        "reference/rotor_kit", "Reference machine, rotor kit at 70 rev/s: exact, and as probes read it every 1 ms", LAST,
        cells("70:0.5"), ("--sample-s", "1e-3", "--noise-m", "2e-6")),
}
