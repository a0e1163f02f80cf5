"""Measures of the domains of a map: what area they take up, how they lean, what lies between them. Of lists of MapCell.

The paper's figures have linear axes, so that the eye weighs areas: a row of the map counts with its height, half way to
its neighbours, however close its rows are.
"""

import statistics


def row_heights(cells):
    """A dict from each whirl ratio to the height of its row on a linear axis; the first and the last row reach as far out
    as in. A single row is 1 high."""
    ratios = sorted({cell.ratio for cell in cells})
    if len(ratios) < 2:
        return {ratio: 1.0 for ratio in ratios}
    inner = [(low + high) / 2 for low, high in zip(ratios, ratios[1:])]
    edges = [2 * ratios[0] - inner[0], *inner, 2 * ratios[-1] - inner[-1]]
    return {ratio: above - below for ratio, below, above in zip(ratios, edges, edges[1:])}


class Areas:
    """Areas within the map of all these cells, whose speeds are evenly spaced."""

    def __init__(self, cells):
        self._cells = cells
        self._heights = row_heights(cells)
        speeds = sorted({cell.speed for cell in cells})
        self.column = (speeds[-1] - speeds[0]) / (len(speeds) - 1) if len(speeds) > 1 else 0.0

    def of(self, part):
        return sum(self._heights[cell.ratio] for cell in part)

    def share(self, part, whole=None):
        """Area of the cells `part` over that of `whole` (all of the map without one), 0 where there is nothing."""
        area = self.of(self._cells if whole is None else whole)
        return self.of(part) / area if area else 0.0

    def lean(self, part):
        """Natural frequencies by which these cells move up in speed from their lowest to their highest row, along the
        straight line of least squares; None where all have one ratio."""
        points = [(cell.ratio, cell.speed, self._heights[cell.ratio]) for cell in part]
        rise = slope(points)
        return None if rise is None else rise * (max(cell.ratio for cell in part) - min(cell.ratio for cell in part))

    def mean_width(self, belongs, in_row):
        """Natural frequencies that the cells which belong take up in the rows whose ratio `in_row` says yes to, on the mean
        over their heights; None where there is no such row."""
        height = sum(height for ratio, height in self._heights.items() if in_row(ratio))
        part = [cell for cell in self._cells if in_row(cell.ratio) and belongs(cell)]
        return self.column * self.of(part) / height if height else None

    def parted_share(self, n):
        """How much of the height of the rows with both 1/n and 1/(n + 1) motions has a gap between the medians of the
        two: at least a fifth of the cells between them is quiet. None where no row has both."""
        rows = [(ratio, row, medians(row, n)) for ratio, row in rows_by_ratio(self._cells).items()]
        rows = [(ratio, between(row, *found)) for ratio, row, found in rows if found]
        whole = sum(self._heights[ratio] for ratio, _ in rows)
        parted = sum(self._heights[ratio] for ratio, cells in rows if len(quiet(cells)) >= GAP_SHARE * max(1, len(cells)))
        return parted / whole if rows else None


# A fifth: between the middles of two domains each of them takes up some two fifths where they nearly meet.
GAP_SHARE = 0.2


def lowest_speed(cells):
    return min((cell.speed for cell in cells), default=None)


def highest_speed(cells):
    return max((cell.speed for cell in cells), default=None)


def least_ratio(cells):
    return min((cell.ratio for cell in cells), default=None)


def slope(points):
    """Slope of the straight line of least squares through (abscissa, ordinate, weight), None where all abscissae are one."""
    if len({x for x, _, _ in points}) < 2:
        return None
    whole = sum(weight for _, _, weight in points)
    mean_x = sum(weight * x for x, _, weight in points) / whole
    mean_y = sum(weight * y for _, y, weight in points) / whole
    covariance = sum(weight * (x - mean_x) * (y - mean_y) for x, y, weight in points)
    return covariance / sum(weight * (x - mean_x) ** 2 for x, _, weight in points)


def rows_by_ratio(cells):
    """A dict from each whirl ratio to its cells, both in the order in which they come."""
    rows = {}
    for cell in cells:
        rows.setdefault(cell.ratio, []).append(cell)
    return rows


def medians(row, n):
    """The median speeds of the 1/n and the 1/(n + 1) cells of a row, None where it lacks one of them."""
    speeds = [[cell.speed for cell in row if cell.subharmonic(order)] for order in (n, n + 1)]
    return [statistics.median(found) for found in speeds] if all(speeds) else None


def between(row, low, high):
    """The cells of a row between two speeds."""
    return [cell for cell in row if low < cell.speed < high]


def quiet(cells):
    return [cell for cell in cells if cell.name == "non_contact"]


def gap_cells(cells, n):
    """The middle quiet cell between the medians of 1/n and 1/(n + 1), one of each row that has a gap there."""
    found = []
    for row in rows_by_ratio(cells).values():
        ends = medians(row, n)
        inside = between(row, *ends) if ends else []
        calm = quiet(inside)
        if calm and len(calm) >= GAP_SHARE * len(inside):
            found.append(calm[(len(calm) - 1) // 2])
    return found


def row_tops(cells):
    """A dict from the whirl ratio to the highest speed among these cells, in natural frequencies."""
    tops = {}
    for cell in cells:
        tops[cell.ratio] = max(cell.speed, tops.get(cell.ratio, 0.0))
    return tops


def gains(tops, other_tops, ratios, other_ratios, share, lowest):
    """By how many natural frequencies each of the rows `ratios` reaches higher than the other map at `share` times its
    ratio, a list over the rows in which one of the two has something.

    `tops` are those of row_tops; a row without one counts as `lowest`, the lowest speed of the maps. Between two rows of
    the other map its top is interpolated, beyond its last ones there is nothing to compare with.
    """
    found = []
    for ratio in sorted(ratios):
        other = _top_at(other_tops, other_ratios, share * ratio, lowest)
        if other is None or (ratio not in tops and other == lowest):
            continue
        found.append(tops.get(ratio, lowest) - other)
    return found


def _top_at(tops, ratios, ratio, lowest):
    below = max((r for r in ratios if r <= ratio * (1 + 1e-6)), default=None)
    above = min((r for r in ratios if r >= ratio * (1 - 1e-6)), default=None)
    if below is None or above is None:
        return None
    low, high = tops.get(below, lowest), tops.get(above, lowest)
    return low if above <= below else low + (high - low) * (ratio - below) / (above - below)


def hits_per_whirl(cell):
    """Hits of an oval while it goes once about the centre.

    The dominant line is only known to 1/64 of the shaft speed, the comb's spacing well. Where 1X is the largest line,
    the whirl's own is taken to be the next one of the comb.
    """
    own = 1 - cell.comb_spacing
    near = abs(cell.dominant_order - 1) < 1 / 64 or abs(cell.dominant_order - own) < 1 / 64
    return cell.hits / abs(own if near else cell.dominant_order)
