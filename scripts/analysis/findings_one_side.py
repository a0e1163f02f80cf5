"""Findings of the stop on one side."""

from domain_measures import gaps, lean, least_ratio, lowest_speed
from finding import (
    HALF,
    HOLDS,
    MOST,
    NOT_REPRODUCED,
    PARTLY,
    SHARES,
    Finding,
    Outcome,
    figure,
    percent,
    share,
    with_and_without_filter,
)
from gap_approaches import approaches, until_first_miss
from map_cells import MapCell

ORDERS = (2, 3, 4, 5)
# The orders between which the domains part: a 1/6 domain is cut off by the end of the map.
GAP_ORDERS = (2, 3, 4)
BETWEEN_CHANCE_AND_ALL = 0.75
OWN = "1/{n} cells that hit once in {n} turns, as the motions of figure 7 do; without filter every 1/{n} cell"


def every(_):
    return True


def start_of(n):
    def measure(machine):
        cells = [cell for cell in machine.cells("one_side") if cell.subharmonic(n)]
        own = lowest_speed([cell for cell in cells if cell.own_domain()])
        lowest = lowest_speed(cells)
        verdict = with_and_without_filter(lowest is not None and lowest > n, own is not None and own > n)
        return Outcome(figure(own), figure(lowest), verdict)

    return Finding(
        title=f"1: one side: 1/{n} starts above {n} natural frequencies",
        paper="These vibration occurs in higher speed of n integer multiple of the eigen frequency.",
        counted="lowest speed over the natural frequency",
        cells=OWN.format(n=n),
        threshold=f"more than {n}, which is what the paper says; partly where it is so of the filtered cells alone",
        roles=("one_side",),
        measure=measure,
    )


def lean_of(n):
    def measure(machine):
        cells = [cell for cell in machine.cells("one_side") if cell.subharmonic(n)]
        own, all_lean = lean([cell for cell in cells if cell.own_domain()]), lean(cells)
        verdict = with_and_without_filter(all_lean is not None and all_lean > 0, own is not None and own > 0)
        return Outcome(figure(own), figure(all_lean), verdict)

    return Finding(
        title=f"1: one side: 1/{n} moves up in speed with unbalance",
        paper="As the unbalance increases, the 1/n sub harmonic vibration occurs in higher rotating speed.",
        counted="slope of the straight line through the speeds over the whirl ratios, natural frequencies per unit",
        cells=OWN.format(n=n),
        threshold="more than 0, the sign is what the paper says; partly where it is so of the filtered cells alone",
        roles=("one_side",),
        measure=measure,
    )


def unbalance_of_orders(machine):
    def least(belongs):
        cells = machine.cells("one_side")
        return [least_ratio([cell for cell in cells if cell.subharmonic(n) and belongs(cell)]) for n in ORDERS]

    def falls(ratios, strictly):
        if None in ratios:
            return False
        pairs = list(zip(ratios, ratios[1:]))
        return all(a > b for a, b in pairs) if strictly else all(a >= b for a, b in pairs) and ratios[0] > ratios[-1]

    own, unfiltered = least(MapCell.own_domain), least(every)
    verdict = NOT_REPRODUCED
    if falls(unfiltered, strictly=True):
        verdict = HOLDS
    elif falls(unfiltered, strictly=False) or falls(own, strictly=False):
        verdict = PARTLY
    return Outcome(", ".join(map(figure, own)), ", ".join(map(figure, unfiltered)), verdict)


def _gap_rows(machine, n, belongs):
    rows = gaps(machine.cells("one_side"), n, belongs)
    return sum(1 for row in rows if row), len(rows)


def gaps_between_domains(machine):
    def rows_of(belongs):
        return [_gap_rows(machine, n, belongs) for n in GAP_ORDERS]

    def text(rows):
        return ", ".join(f"{parted} of {both}" for parted, both in rows)

    def least(rows):
        return min(share(parted, both) for parted, both in rows)

    own, unfiltered = rows_of(MapCell.own_domain), rows_of(every)
    verdict = NOT_REPRODUCED
    if least(unfiltered) > MOST:
        verdict = HOLDS
    elif max(least(unfiltered), least(own)) > HALF:
        verdict = PARTLY
    return Outcome(text(own), text(unfiltered), verdict)


def gap_cells(machine, belongs):
    """The middle cell of every gap between two domains, row by row."""
    rows = [row for n in ORDERS for row in gaps(machine.cells("one_side"), n, belongs) if row]
    return [row[(len(row) - 1) // 2] for row in rows]


def casing_approaches(machine, filtered):
    """Filtered: all times that the rotor comes near the wall in the middle cells of the gaps, while it rubs. Without
    filter: in the gaps between all motions of two orders, up to the end of the run."""
    key = ("approaches", filtered)
    if key not in machine.memory:
        config = machine.maps["one_side"]
        cells = gap_cells(machine, MapCell.own_domain if filtered else every)

        def of_cell(cell):
            rows = machine.trajectory("one_side", cell, ("t_s", "y_m", "casing_0_y_m", "gap_0_m"), revolutions=128)
            found = approaches(rows, config.number("stops.0.clearance_m"), config.number("kick.duration_s"))
            return until_first_miss(found) if filtered else found

        machine.memory[key] = len(cells), [one for found in machine.each(of_cell, cells) for one in found]
    return machine.memory[key]


def of_approaches(machine, counts, text, bound_partly):
    """The outcome for the approaches that `counts` is true of; `text` says it of (number, approaches, cells)."""

    def counted(filtered):
        cells, found = casing_approaches(machine, filtered)
        return sum(map(counts, found)), found, cells

    filtered, unfiltered = counted(True), counted(False)
    # A machine without domains of one hit in n turns has none of the filtered gaps.
    part, found, _ = filtered if filtered[1] else unfiltered
    of_found = share(part, len(found))
    verdict = HOLDS if of_found > MOST else PARTLY if of_found > bound_partly else NOT_REPRODUCED
    return Outcome(text(*filtered), text(*unfiltered), verdict)


def casing_away(machine):
    def text(part, found, cells):
        farthest = max((approach.displacement for approach in found), default=None)
        return f"{part} of {len(found)} approaches in {cells} cells, farthest {figure(farthest)} clearances"

    return of_approaches(machine, lambda approach: approach.displacement > 1, text, HALF)


def casing_moving_away(machine):
    def text(part, found, _):
        return f"{part} of {len(found)} approaches ({percent(part, len(found))})"

    return of_approaches(machine, lambda approach: approach.velocity > 0, text, BETWEEN_CHANCE_AND_ALL)


GAP_SENTENCE = (
    "In the gap where rubbing vibration is unlikely to occur, the casing is more than clearance away and moving away "
    "from the rotor."
)
GAP_CELLS = (
    "the middle cell of each gap between two domains of one hit in n turns, until the first miss after the last hit; "
    "without filter the gaps between all 1/n and 1/(n + 1) motions, for 128 turns, which decides where no domain is "
    "of one hit in n turns"
)

FINDINGS = [finding(n) for n in ORDERS for finding in (start_of, lean_of)] + [
    Finding(
        title="1: one side: larger n from smaller unbalance",
        paper="As the integer n becomes larger, the 1/n sub harmonic rubbing vibration occurs from smaller unbalance region.",
        counted="least whirl ratio of 1/2, 1/3, 1/4, 1/5",
        cells="those that hit once in n turns; without filter every 1/n cell",
        threshold="falls from each order to the next; partly where it falls from first to last and never rises",
        roles=("one_side",),
        measure=unbalance_of_orders,
    ),
    Finding(
        title="1: one side: gaps between the domains",
        paper="The domain of the rubbing vibration occurrence shows a gap.",
        counted="rows of the whirl ratio with cells without contact between the last 1/n and the first 1/(n + 1) cell, of "
        "the rows with both; n = 2, 3, 4",
        cells="those that hit once in n turns; without filter every 1/n cell",
        threshold="without filter for each n above 90 % of the rows (rims), partly above 50 %, filtered or not",
        roles=("one_side",),
        measure=gaps_between_domains,
    ),
    Finding(
        title="1: one side: casing a clearance away in the gaps",
        paper=GAP_SENTENCE,
        counted="approaches of the rotor after the kick at which the casing is more than a clearance away",
        cells=GAP_CELLS,
        threshold=SHARES,
        roles=("one_side",),
        measure=casing_away,
    ),
    Finding(
        title="1: one side: casing moving away in the gaps",
        paper=GAP_SENTENCE,
        counted="approaches of the rotor after the kick at which the casing moves away",
        cells=GAP_CELLS,
        threshold="holds above 90 % (the rims of a domain are a tenth of it), partly above 75 % (half of them do by chance)",
        roles=("one_side",),
        measure=casing_moving_away,
    ),
]
