"""Shapes of a whirling shaft in three dimensions, in a parallel projection: the shaft lies along the axis of the picture, y points
up, and x up to the right."""

import cmath
import math

PARTS = 48  # of an orbit
MOST_ORBITS = 15
# Where a deflection along x leads, to the right in lengths of the shaft and up: shares of one along y.
RIGHT, UP = 0.07, 0.4


def shape_of(rows):
    """(position, x, y) with complex deflections from the rows of a table."""
    return [(row["position_m"], complex(row["x_real"], row["x_imag"]), complex(row["y_real"], row["y_imag"])) for row in rows]


def largest(shape):
    """The largest deflection in a turn at any place: half of the major axis."""
    return max((major(x, y) for _, x, y in shape), default=0.0)


def major(x, y):
    """Half of the major axis of an orbit Re(x e^iwt), Re(y e^iwt)."""
    return (abs(x + 1j * y) + abs(x - 1j * y)) / 2


def turned(shape):
    """The shape at the instant at which the place that moves most is at the end of its major axis."""
    _, x, y = max(shape, key=lambda place: major(place[1], place[2]))
    forward, backward = (x + 1j * y) / 2, (x - 1j * y) / 2  # z = forward e^iwt + conj(backward) e^-iwt
    if abs(forward) > 0 and abs(backward) > 0:
        angle = (cmath.phase(backward.conjugate()) - cmath.phase(forward)) / 2
    else:
        angle = -cmath.phase(x if abs(x) > 0 else y)
    return [(position, x * cmath.exp(1j * angle), y * cmath.exp(1j * angle)) for position, x, y in shape]


def line_lines(shape):
    """The bent line as points of the picture: mm along the shaft, and shares of the largest deflection."""
    whole, length = largest(shape) or 1, shape[-1][0] - shape[0][0]
    return [_point(position, x.real / whole, y.real / whole, length) for position, x, y in shape]


def orbit_lines(shape):
    """The orbits of some places likewise, a block for each."""
    whole, length = largest(shape) or 1, shape[-1][0] - shape[0][0]
    for index in spread(len(shape)):
        position, x, y = shape[index]
        for part in range(PARTS + 1):
            turn = cmath.exp(2j * math.pi * part / PARTS) / whole
            yield _point(position, (x * turn).real, (y * turn).real, length)
        yield ""


def _point(position_m, x, y, length_m):
    return "%.17g %.17g" % (1e3 * (position_m + RIGHT * length_m * x), y + UP * x)


def spread(count):
    """Indices of at most MOST_ORBITS places, evenly, with both ends."""
    if count <= MOST_ORBITS:
        return range(count)
    return sorted({round(i * (count - 1) / (MOST_ORBITS - 1)) for i in range(MOST_ORBITS)})
