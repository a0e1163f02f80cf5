"""The ellipse that the largest forward line off 1X and the largest backward line of a full spectrum make."""

import math
from dataclasses import dataclass

# A line that falls between bins spreads: so many bins on either side are counted with it.
BINS_BESIDE = 3


@dataclass(frozen=True)
class Ellipse:
    axes: float  # short axis / long axis
    precession: float  # turns per revolution of the shaft
    energy_share: float  # of these two lines in the energy without 0X and 1X

    def nearly_closed_oval(self):
        """Whether it is flattened by more than a tenth, turns by less than a tenth of a turn per revolution, and holds
        four fifths of the energy."""
        return self.axes < 0.9 and abs(self.precession) < 0.1 and self.energy_share > 0.8


def ellipse(spectrum):
    """The shape by a list of (order, amplitude) in rising order; None where there is no line off 0X and 1X on both sides."""

    def counts(i):
        return 0 <= i < len(spectrum) and spectrum[i][0] not in (0.0, 1.0)

    def largest(sign):
        return max(
            (i for i, (order, amplitude) in enumerate(spectrum) if counts(i) and sign * order > 0 and amplitude > 0),
            key=lambda i: spectrum[i][1],
            default=None,
        )

    def held(line):
        beside = range(line - BINS_BESIDE, line + BINS_BESIDE + 1)
        return math.sqrt(sum(spectrum[i][1] ** 2 for i in beside if counts(i)))

    forward, backward = largest(1), largest(-1)
    if forward is None or backward is None:
        return None
    f, b = held(forward), held(backward)
    energy = sum(amplitude**2 for i, (_, amplitude) in enumerate(spectrum) if counts(i))
    return Ellipse(
        axes=abs(f - b) / (f + b),
        precession=(spectrum[forward][0] + spectrum[backward][0]) / 2,
        energy_share=(f**2 + b**2) / energy,
    )
