"""Lays out the column `threshold` of a map.csv for threshold_map.gp: cells as boxes, and a grid for its contours."""

import csv_table
import domain_map


def read_cells(path, across, up, natural_frequency_hz=None):
    """[(x, y, threshold)]; the threshold is None where rub goes on after no number of the scan."""
    cells = []
    for row in csv_table.read_table(path, across, up, "threshold"):
        if row[up]:
            x = csv_table.number(row, across) / (natural_frequency_hz or 1)
            cells.append((x, csv_table.number(row, up), csv_table.number(row, "threshold")))
    if all(threshold is None for _, _, threshold in cells):
        raise csv_table.TableError(f"{path}: no cell has a threshold")
    return cells


def box_lines(cells):
    """One line per cell: x y left right bottom top threshold, `NaN` without one."""
    sides = domain_map.edges(cell[0] for cell in cells), domain_map.edges(cell[1] for cell in cells)
    for x, y, threshold in cells:
        yield " ".join(_digits(value) for value in (x, y, *sides[0][x], *sides[1][y], threshold))


def grid_lines(cells):
    """Blocks of x y threshold, one for each x: what gnuplot draws contours of."""
    values = {(x, y): threshold for x, y, threshold in cells}
    rows = sorted({y for _, y in values})
    for x in sorted({x for x, _ in values}):
        for y in rows:
            yield " ".join(_digits(value) for value in (x, y, values.get((x, y))))
        yield ""


def levels(cells):
    """Where contours are drawn: 1, 2 and 5 times powers of ten between the smallest and the largest threshold."""
    found = [threshold for _, _, threshold in cells if threshold is not None]
    powers = [mantissa * 10.0**exponent for exponent in range(-12, 13) for mantissa in (1, 2, 5)]
    return [level for level in powers if min(found) < level < max(found)]


def _digits(value):
    return "NaN" if value is None else "%.17g" % value
