"""Paints the cells that a refined map did not compute, as the program itself takes them: those of a block whose computed
cells are all equal are equal to them. Axes are given by their sizes; a cell is (i, j), i across."""

from rubplot import domain_map


def lattice(count, levels):
    """The stretches between lattice lines, both ends included."""
    if count == 1:
        return [(0, 0)]
    step = 2**levels
    return [(first, min(first + step, count - 1)) for first in range(0, count - 1, step)]


def painted(known, across, up, levels):
    """A dict of all cells of which something is known, from `known`, a dict of the computed ones."""
    found = dict(known)
    blocks = [(i, j) for j in lattice(up, levels) for i in lattice(across, levels)]
    while blocks:
        i, j = blocks.pop()
        inside = [(a, b) for b in range(j[0], j[1] + 1) for a in range(i[0], i[1] + 1)]
        labels = {known[cell] for cell in inside if cell in known}
        if len(labels) == 1:
            label = labels.pop()
            found.update((cell, label) for cell in inside)
        elif i[1] - i[0] > 1 or j[1] - j[0] > 1:
            blocks += [(a, b) for b in _halves(j) for a in _halves(i)]
    return found


def painted_cells(cells, across, up, levels):
    """The cells of domain_map.read_cells with those that were not computed; `across` and `up` are the values of the
    axes in the order of the sweep, in units of which the cells may show others, such as rpm."""
    across = _in_units_of([cell.x for cell in cells], across)
    up = _in_units_of([cell.y for cell in cells], up)
    places = [(_nearest(across, cell.x), _nearest(up, cell.y)) for cell in cells]
    known = {place: cell.kind for place, cell in zip(places, cells)}
    strengths = {place: cell.strength for place, cell in zip(places, cells)}
    found = painted(known, len(across), len(up), levels)
    return [
        domain_map.Cell(across[i], up[j], kind, strengths.get((i, j), 1)) for (i, j), kind in sorted(found.items())
    ]


def _in_units_of(shown, values):
    """A refined map has the cells at both ends of every axis, and units differ by a factor."""
    largest = max(values, key=abs)
    factor = max(shown, key=abs) / largest if largest else 1
    return values if abs(factor - 1) < 1e-12 else [value * factor for value in values]


def _nearest(values, value):
    """Units that were divided and multiplied differ in the last digits."""
    return min(range(len(values)), key=lambda i: abs(values[i] - value))


def _halves(stretch):
    first, last = stretch
    if last - first <= 1:
        return [stretch]
    middle = first + (last - first) // 2
    return [(first, middle), (middle, last)]
