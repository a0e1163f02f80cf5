"""Measures of the domains of a map: where they begin, how they lean, what lies between them. Of lists of MapCell."""


def lowest_speed(cells):
    return min((cell.speed for cell in cells), default=None)


def highest_speed(cells):
    return max((cell.speed for cell in cells), default=None)


def least_ratio(cells):
    return min((cell.ratio for cell in cells), default=None)


def lean(cells):
    """Slope of the straight line of least squares through the speeds over the whirl ratios, in natural frequencies per
    unit of the ratio; None where all cells have one ratio."""
    return slope([(cell.ratio, cell.speed) for cell in cells])


def slope(points):
    """Slope of the straight line of least squares, None where all abscissae are one."""
    if len({x for x, _ in points}) < 2:
        return None
    mean_x = sum(x for x, _ in points) / len(points)
    mean_y = sum(y for _, y in points) / len(points)
    return sum((x - mean_x) * (y - mean_y) for x, y in points) / sum((x - mean_x) ** 2 for x, _ in points)


def rows_by_ratio(cells):
    """A dict from each whirl ratio to its cells, both in the order in which they come."""
    rows = {}
    for cell in cells:
        rows.setdefault(cell.ratio, []).append(cell)
    return rows


def gaps(cells, n, belongs):
    """What lies between the 1/n and the 1/(n + 1) domain: one list for each row of the whirl ratio that has both, of the
    cells without contact between the last 1/n and the first 1/(n + 1) cell. `belongs` says which cells of an order are
    of its domain."""
    found = []
    for row in rows_by_ratio(cells).values():
        lower = [cell.speed for cell in row if cell.subharmonic(n) and belongs(cell)]
        upper = [cell.speed for cell in row if cell.subharmonic(n + 1) and belongs(cell)]
        if lower and upper:
            low, high = max(lower), min(upper)
            found.append([cell for cell in row if cell.name == "non_contact" and low < cell.speed < high])
    return found


def widths(cells, belongs):
    """Points (whirl ratio, width), one for each row: how many natural frequencies its cells that belong take up, each
    reaching half way to its neighbours. The map's speeds are evenly spaced."""
    speeds = sorted({cell.speed for cell in cells})
    if len(speeds) < 2:
        return []
    step = (speeds[-1] - speeds[0]) / (len(speeds) - 1)
    return [(ratio, step * sum(map(belongs, row))) for ratio, row in rows_by_ratio(cells).items()]


def row_tops(cells):
    """A dict from the whirl ratio to the highest speed in Hz among these cells."""
    tops = {}
    for cell in cells:
        tops[cell.ratio] = max(cell.speed_hz, tops.get(cell.ratio, 0.0))
    return tops


def rows_reaching_higher(tops, other_tops, ratios, other_ratios, share=1.0):
    """How many of the rows `ratios` reach higher speed than the other map, and how many rows there are with either.

    `tops` are those of row_tops. A row is compared with that at `share` times its ratio in the other map; where that
    lies between two rows, it has to reach higher than both.
    """
    higher = compared = 0
    for ratio in ratios:
        top, other = tops.get(ratio, 0.0), _top_about(other_tops, other_ratios, share * ratio)
        compared += bool(top or other)
        higher += top > other * (1 + 1e-9)
    return higher, compared


def _top_about(tops, ratios, ratio):
    below = [r for r in ratios if r <= ratio * (1 + 1e-9)]
    above = [r for r in ratios if r >= ratio * (1 - 1e-9)]
    return max(tops.get(max(below), 0.0) if below else 0.0, tops.get(min(above), 0.0) if above else 0.0)


def hits_per_whirl(cell):
    """Hits of an oval while it goes once about the centre.

    The dominant line is only known to 1/64 of the shaft speed, the comb's spacing well. Where 1X is the largest line,
    the whirl's own is taken to be the next one of the comb.
    """
    own = 1 - cell.comb_spacing
    near = abs(cell.dominant_order - 1) < 1 / 64 or abs(cell.dominant_order - own) < 1 / 64
    return cell.hits / abs(own if near else cell.dominant_order)
