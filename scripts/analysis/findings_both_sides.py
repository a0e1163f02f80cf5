"""Findings of stops on both sides."""

from collections import Counter

from domain_measures import Areas
from finding import HOLDS, NOT_REPRODUCED, PARTLY, SHARES, Finding, Outcome, figure, of_both, of_share, percent
from named_motions import nothing_else, one_of_n, synchronous
from rubplot.evenly_spread import spread

SAMPLED_CELLS = 24
# A figure hides a cell in fifty; a tenth is the rims.
HIDDEN, RIMS = 0.02, 0.1


def synchronous_range(machine):
    areas = Areas(machine.cells("both_sides"))
    large = areas.mean_width(synchronous, lambda ratio: ratio >= 0.5)
    small = areas.mean_width(synchronous, lambda ratio: ratio < 0.25)
    wide = large is not None and large > 1
    wider = large is not None and small is not None and large > small
    return Outcome(f"{figure(large, 1)} wide at large, {figure(small, 1)} at small unbalance", of_both(wide, wider))


def subharmonics(machine, role):
    return [cell for cell in machine.cells(role) if cell.subharmonic()]


def subharmonic_unbalance(machine):
    cells, areas = subharmonics(machine, "both_sides"), Areas(machine.cells("both_sides"))
    small = areas.share([cell for cell in cells if cell.ratio <= 0.5], cells) if cells else None
    return Outcome(f"{percent(small)} of {len(cells)} cells", of_share(small))


def is_even(cell):
    return cell.order % 2 == 0


def even_share(machine, role):
    cells = subharmonics(machine, role)
    return Areas(machine.cells(role)).share([cell for cell in cells if is_even(cell)], cells)


def orders(machine, role):
    """The share that is even, and how many cells of which even order."""
    cells = subharmonics(machine, role)
    even = Counter(cell.order for cell in cells if is_even(cell))
    listed = ", ".join(f"{count} of 1/{n}" for n, count in sorted(even.items())) or "none"
    return f"{percent(even_share(machine, role))} of {len(cells)} cells by area ({listed})"


def only_odd(machine):
    third = any(cell.subharmonic(3) for cell in machine.cells("both_sides"))
    even, verdict = even_share(machine, "both_sides"), NOT_REPRODUCED
    if third and even <= RIMS:
        verdict = HOLDS if even <= HIDDEN else PARTLY
    return Outcome(orders(machine, "both_sides"), verdict)


def even_return(machine):
    equal, unequal = even_share(machine, "both_sides"), even_share(machine, "both_sides_unequal")
    verdict = NOT_REPRODUCED
    if unequal > RIMS and unequal > 2 * equal:
        verdict = HOLDS
    elif unequal > equal:
        verdict = PARTLY
    return Outcome(orders(machine, "both_sides_unequal"), verdict)


def touches_one_side(machine, cell):
    rows = machine.trajectory("both_sides_unequal", cell, ("gap_0_m", "gap_1_m"), last_revolutions=64)
    return any(gap < 0 for gap, _ in rows) != any(gap < 0 for _, gap in rows)


def one_sided_contact(machine):
    rub = [cell for cell in machine.cells("both_sides_unequal") if cell.rubs()]
    likely = [cell for cell in rub if cell.subharmonic() and is_even(cell) and cell.hits * cell.order < 1.5]
    found = []
    for cells in (likely, rub):
        chosen = spread(cells, SAMPLED_CELLS)
        found.append((sum(machine.each(lambda cell: touches_one_side(machine, cell), chosen)), len(chosen)))
    text = "%d of %d cells of one hit in n turns, %d of %d of all" % (*found[0], *found[1])
    return Outcome(text, HOLDS if any(count for count, _ in found) else NOT_REPRODUCED)


DIFFERENCE = (
    "However, if there is a difference between the two casings, the rotor sometimes contacts with the casings only at one "
    "side."
)

FINDINGS = [
    Finding(
        title="2: both sides: synchronous over a wide speed range",
        paper="As the unbalance gets larger, synchronous vibration occurs in the region of wide rotating speed range.",
        counted="natural frequencies that synchronous cells take up in the rows from a whirl ratio of 0.5 on, and below 0.25, "
        "on the mean",
        threshold="more than 1 at large unbalance, the distance of two subharmonic domains, and more than at small unbalance; "
        "partly one of the two",
        reason="wide is said beside the domains of 1/n, and getting larger is a comparison of ends, of no single row",
        roles=("both_sides",),
        measure=synchronous_range,
    ),
    Finding(
        title="2: both sides: subharmonic at small unbalance only",
        paper="The sub harmonic rubbing vibration just occurs in the region of moderately small unbalance.",
        counted="area of the subharmonic cells up to a whirl ratio of 0.5, the middle of the map",
        threshold=SHARES,
        reason="moderately small is the lower half, and a number of our own",
        roles=("both_sides",),
        measure=subharmonic_unbalance,
    ),
    Finding(
        title="2: both sides: only odd orders with equal casings",
        paper="In the both side contact case, only the odd number sub harmonic vibration occurs.",
        counted="area of even orders, of that of all subharmonic cells",
        threshold="2 % at most, and 1/3 is there; partly up to 10 %, the rims of the odd domains",
        reason="only says none, and a figure hides a cell in fifty",
        roles=("both_sides",),
        measure=only_odd,
    ),
    Finding(
        title="2: both sides: even orders with unequal casings",
        paper=DIFFERENCE + " (That even orders then return is what this implies.)",
        counted="area of even orders, of that of all subharmonic cells",
        threshold="more than 10 % (more than rims) and twice the share between equal casings; partly where it only rises",
        reason="a return is more than rims, and more than there is between equal casings",
        roles=("both_sides", "both_sides_unequal"),
        measure=even_return,
    ),
    Finding(
        title="2: both sides: unequal casings, contact on one side",
        paper=DIFFERENCE,
        counted=f"cells whose last 64 revolutions touch one stop only, of {SAMPLED_CELLS} spread over those of even order that "
        f"hit once in n turns, and of {SAMPLED_CELLS} over all that rub",
        threshold="one cell",
        reason="sometimes says no more; a sample is looked at, because the map does not say which stop is hit",
        roles=("both_sides_unequal",),
        measure=one_sided_contact,
    ),
    nothing_else(
        "2: both sides: nothing but synchronous and 1/n motions",
        "both_sides",
        (synchronous, one_of_n),
        "synchronous or 1/2 to 1/7",
    ),
]
