"""Lays out a map.csv for map.gp: where each cell lies, of which kind it is, and where 1/n can be written.

A cell reaches half way to its neighbours.
"""

import math
import os
from dataclasses import dataclass, replace

from rubplot import csv_table, motion_kinds
from rubplot.motion_kinds import kind_of

# Share of an axis that a label hides on either side of its middle.
LABEL_REACH = 0.02


@dataclass(frozen=True)
class Cell:
    """One cell: x is the speed over the natural frequency (in Hz where there is none), y the unbalance; `strength`, from
    0 to 1, is how much of its colour is shown."""

    x: float
    y: float
    kind: str
    strength: float = 1


@dataclass(frozen=True)
class Label:
    x: float
    y: float
    text: str


def read_cells(path, measure, natural_frequency_hz=None, across="speed_hz", strength=None):
    """The cells of a map over two columns: `across`, the speed where it is not another, and `measure`. `strength` is a
    column of shares; a cell without one is shown in full."""
    cells = []
    columns = [across, "class", "order", measure] + ([strength] if strength else [])
    for row in csv_table.read_table(path, *columns):
        if not row[measure]:
            continue
        x = csv_table.number(row, across) / (natural_frequency_hz or 1)
        share = csv_table.number(row, strength) if strength and row[strength] else 1
        cells.append(Cell(x, csv_table.number(row, measure), kind_of(row), min(max(share, 0), 1)))
    if not cells:
        raise csv_table.TableError(f"{path}: no cells")
    return cells


def scaled(cells, boundaries, across, up):
    """The same cells and lines in units of which there are so many in one."""
    if across == up == 1:
        return cells, boundaries
    return (
        [replace(cell, x=across * cell.x, y=up * cell.y) for cell in cells],
        {kind: [[(across * x, up * y) for x, y in line] for line in lines] for kind, lines in boundaries.items()},
    )


def boundary_kind(kind):
    """How the picture parts the kinds of boundaries.csv."""
    named = {"fold": "fold", "period_doubling": "doubling", "period_halving": "doubling", "neimark_sacker": "torus"}
    return named.get(kind, "other")


def read_boundaries(path, measure, natural_frequency_hz=None, digest=None):
    """The lines of boundaries.csv by what the picture calls them, each a list of points; nothing where there is no such
    file, or where it says that it is of a map of another digest."""
    found = {}
    if not os.path.exists(path) or csv_table.digest(path) not in (None, digest):
        return found
    line = []
    for row in csv_table.read_table(path, "family", "kind", "speed_hz", measure):
        if not row["speed_hz"]:
            line = []
            continue
        if not line:
            found.setdefault(boundary_kind(row["kind"]), []).append(line)
        line.append((csv_table.number(row, "speed_hz") / (natural_frequency_hz or 1), csv_table.number(row, measure)))
    return dict(sorted(found.items()))


def boundary_lines(boundaries):
    """A block of lines for every kind, two empty lines before each block and one behind each line of a boundary."""
    for lines in boundaries.values():
        yield "\n"
        for line in lines:
            # A single point would not be seen.
            for x, y in line if len(line) > 1 else line * 2:
                yield f"{_digits(x)} {_digits(y)}"
            yield ""


def edges(values, logarithmic=False):
    """A dict from each distinct value to the two edges of the cells there, which on a logarithmic axis are half way in
    its logarithm; a value alone is 0.2 wide."""
    values = sorted(set(values))
    if logarithmic:
        exponents = edges(math.log(value) for value in values)
        return {value: tuple(math.exp(edge) for edge in exponents[math.log(value)]) for value in values}
    if len(values) == 1:
        return {values[0]: (values[0] - 0.05, values[0] + 0.05)}
    found = {}
    for i, value in enumerate(values):
        before = value - values[i - 1] if i > 0 else values[1] - value
        after = values[i + 1] - value if i + 1 < len(values) else before
        found[value] = (value - before / 2, value + after / 2)
    return found


def labels(cells):
    """1/n for every n that has room: in the cell nearest to the middle of all of that order, of those where it fits."""
    columns = {x: i for i, x in enumerate(sorted({cell.x for cell in cells}))}
    rows = {y: i for i, y in enumerate(sorted({cell.y for cell in cells}))}
    kinds = {(columns[cell.x], rows[cell.y]): cell.kind for cell in cells}

    def fits(cell):
        beyond_x, beyond_y = _cells_beyond(len(columns)), _cells_beyond(len(rows))
        return all(
            kinds.get((columns[cell.x] + i, rows[cell.y] + j)) == cell.kind
            for i in range(-beyond_x, beyond_x + 1)
            for j in range(-beyond_y, beyond_y + 1)
        )

    width = max(columns) - min(columns) + 1e-9
    height = max(rows) - min(rows) + 1e-9
    found = []
    for n in range(2, motion_kinds.LARGEST_NAMED_ORDER):
        alike = [cell for cell in cells if cell.kind == f"subharmonic_{n}"]
        room = [cell for cell in alike if fits(cell)]
        if not room:
            continue
        middle_x = sum(cell.x for cell in alike) / len(alike)
        middle_y = sum(cell.y for cell in alike) / len(alike)
        best = min(room, key=lambda cell: ((cell.x - middle_x) / width) ** 2 + ((cell.y - middle_y) / height) ** 2)
        found.append(Label(best.x, best.y, f"1/{n}"))
    return found


def cell_lines(cells, logarithmic=(False, False)):
    """One line per cell: x y left right bottom top kind strength; which axes are logarithmic."""
    across = edges((cell.x for cell in cells), logarithmic[0])
    up = edges((cell.y for cell in cells), logarithmic[1])
    for cell in cells:
        figures = (cell.x, cell.y, *across[cell.x], *up[cell.y])
        yield " ".join(_digits(figure) for figure in figures) + f" {cell.kind} {_digits(cell.strength)}"


def label_text(found):
    """The labels as map.gp takes them: x y text x y text ..."""
    return " ".join(f"{_digits(label.x)} {_digits(label.y)} {label.text}" for label in found)


def _cells_beyond(count):
    """How many cells beyond its own a label reaches on an axis of `count` cells."""
    beyond = LABEL_REACH * count - 0.5
    return 0 if beyond <= 0 else math.floor(beyond) + 1


def _digits(value):
    return "%.17g" % value
