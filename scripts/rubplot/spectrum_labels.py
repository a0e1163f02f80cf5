"""Names the lines of a spectrum that a picture has room for."""

import math
from fractions import Fraction

LARGEST_COUNT = 8
LEAST_SHARE = 0.05  # of the largest line
# The height of the text, which stands upright, as a share of the width of the picture.
LEAST_DISTANCE = 0.048
BESIDE = 0.2  # in orders: how far the picture reaches beyond its largest order


def line_name(order, period=0, comb_spacing=0.0):
    """A line's name: '1/2X', '−3X'.

    `period` is n where the orders are multiples of 1/n, 0 where they are not; `comb_spacing` is s where they are
    1 + k s, which the lines of the spectrum only come near to, and 0 otherwise.
    """
    if comb_spacing:
        order = 1 + _nearest((order - 1) / comb_spacing) * comb_spacing
    sign = "−" if order < 0 else ""
    numerator = _nearest(order * period)
    if not period or abs(numerator - order * period) > 1e-6:
        return f"{sign}{'%.3g' % abs(order)}X"
    sign = "−" if numerator < 0 else ""
    return f"{sign}{abs(Fraction(numerator, period))}X"


def named_lines(spectrum, period=0, comb_spacing=0.0, highest=2):
    """The lines to name, largest first, as (position in the spectrum, name).

    `spectrum` is a list of (order, amplitude) in rising order, drawn to the order `highest` on both sides. At most eight,
    each above its neighbours, above a twentieth of the largest, and not in the way of a larger one.
    """
    least_distance = LEAST_DISTANCE * 2 * (highest + BESIDE)
    amplitudes = [0.0] + [amplitude for _, amplitude in spectrum] + [0.0]
    largest = max(amplitudes)
    peaks = [
        i
        for i, (_, amplitude) in enumerate(spectrum)
        if abs(spectrum[i][0]) <= highest and amplitude > LEAST_SHARE * largest and amplitudes[i] <= amplitude >= amplitudes[i + 2]
    ]
    taken = []
    for i in sorted(peaks, key=lambda i: -spectrum[i][1]):
        if len(taken) == LARGEST_COUNT:
            break
        if all(abs(spectrum[i][0] - spectrum[k][0]) >= least_distance for k in taken):
            taken.append(i)
    return [(i, line_name(spectrum[i][0], period, comb_spacing)) for i in taken]


def _nearest(x):
    """The nearest whole number, halves away from zero."""
    return math.floor(x + 0.5) if x >= 0 else -math.floor(0.5 - x)
