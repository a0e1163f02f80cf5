"""Findings of stops on both sides."""

from collections import Counter

from domain_measures import highest_speed, slope, widths
from finding import HOLDS, NOT_REPRODUCED, PARTLY, SHARES, Finding, Outcome, figure, of_share, percent, share
from rubplot.evenly_spread import spread

SAMPLED_CELLS = 24
TENTH = 0.1


def synchronous_range(machine):
    cells = machine.cells("both_sides")
    points = widths(cells, lambda cell: cell.name == "synchronous")
    width = max(points, default=(0, 0))[1]  # of the row with the largest whirl ratio
    rise = slope(points)
    top = highest_speed([cell for cell in cells if cell.name == "synchronous"])
    wide, wider = width > 1, rise is not None and rise > 0
    verdict = HOLDS if wide and wider else PARTLY if wide or wider else NOT_REPRODUCED
    measured = f"{figure(width, 1)} wide at the largest ratio, slope {figure(rise, 1)}"
    return Outcome(measured, f"up to {figure(top, 1)}", verdict)


def subharmonics(machine, role):
    return [cell for cell in machine.cells(role) if cell.subharmonic()]


def subharmonic_unbalance(machine):
    cells = subharmonics(machine, "both_sides")
    small = sum(cell.ratio <= 0.5 for cell in cells)
    text = f"{percent(small, len(cells))} of {len(cells)} cells"
    return Outcome(text, "the same", of_share(share(small, len(cells))))


def even_share(machine, role):
    cells = subharmonics(machine, role)
    return share(sum(cell.order % 2 == 0 for cell in cells), len(cells))


def orders(machine, role):
    """Even cells of all, and how many of which order."""
    cells = subharmonics(machine, role)
    even = Counter(cell.order for cell in cells if cell.order % 2 == 0)
    listed = ", ".join(f"{count} of 1/{n}" for n, count in sorted(even.items())) or "none"
    return f"{percent(sum(even.values()), len(cells))} of {len(cells)} cells are even ({listed})"


def only_odd(machine):
    cells, even = subharmonics(machine, "both_sides"), even_share(machine, "both_sides")
    verdict = NOT_REPRODUCED
    if cells and even == 0:
        verdict = HOLDS
    elif cells and even < TENTH:
        verdict = PARTLY
    return Outcome(orders(machine, "both_sides"), "the same", verdict)


def even_return(machine):
    equal, unequal = even_share(machine, "both_sides"), even_share(machine, "both_sides_unequal")
    verdict = NOT_REPRODUCED
    if unequal > TENTH and unequal > 2 * equal:
        verdict = HOLDS
    elif unequal > equal:
        verdict = PARTLY
    return Outcome(orders(machine, "both_sides_unequal"), "the same", verdict)


def touches_one_side(machine, cell):
    rows = machine.trajectory("both_sides_unequal", cell, ("gap_0_m", "gap_1_m"), last_revolutions=64)
    return any(gap < 0 for gap, _ in rows) != any(gap < 0 for _, gap in rows)


def one_sided_contact(machine):
    def sampled(cells):
        chosen = spread(cells, SAMPLED_CELLS)
        return sum(machine.each(lambda cell: touches_one_side(machine, cell), chosen)), len(chosen)

    cells = machine.cells("both_sides_unequal")
    even = sampled([cell for cell in cells if cell.subharmonic() and cell.order % 2 == 0])
    rubs = sampled([cell for cell in cells if cell.rubs()])
    found = even[0] > 0 or rubs[0] > 0
    return Outcome("%d of %d sampled cells" % even, "%d of %d sampled cells" % rubs, HOLDS if found else NOT_REPRODUCED)


FINDINGS = [
    Finding(
        title="2: both sides: synchronous over a wide speed range",
        paper="As the unbalance gets larger, synchronous vibration occurs in the region of wide rotating speed range.",
        counted="natural frequencies that synchronous cells take up in a row of the map: at the largest whirl ratio, and "
        "its slope over the whirl ratio; without filter the highest speed of any synchronous cell",
        cells="synchronous cells",
        threshold="more than 1, the distance of two subharmonic domains, and a slope above 0; partly one of the two",
        roles=("both_sides",),
        measure=synchronous_range,
    ),
    Finding(
        title="2: both sides: subharmonic at small unbalance only",
        paper="The sub harmonic rubbing vibration just occurs in the region of moderately small unbalance.",
        counted="subharmonic cells up to a whirl ratio of 0.5, the middle of the map",
        cells="all subharmonic cells, no filter",
        threshold=SHARES,
        roles=("both_sides",),
        measure=subharmonic_unbalance,
    ),
    Finding(
        title="2: both sides: only odd orders with equal casings",
        paper="In the both side contact case, only the odd number sub harmonic vibration occurs.",
        counted="share of even orders",
        cells="all subharmonic cells, no filter",
        threshold="none, as only says; partly below 10 %, the rims of the odd domains",
        roles=("both_sides",),
        measure=only_odd,
    ),
    Finding(
        title="2: both sides: even orders with unequal casings",
        paper="However, if there is a difference between the two casings, the rotor sometimes contacts with the casings "
        "only at one side. (That even orders then return is what this implies.)",
        counted="share of even orders",
        cells="all subharmonic cells, no filter",
        threshold="more than 10 % (more than rims) and twice the share between equal casings; partly where it only rises",
        roles=("both_sides", "both_sides_unequal"),
        measure=even_return,
    ),
    Finding(
        title="2: both sides: unequal casings, contact on one side",
        paper="However, if there is a difference between the two casings, the rotor sometimes contacts with the casings "
        "only at one side.",
        counted="cells whose last 64 revolutions touch one stop only",
        cells=f"{SAMPLED_CELLS} cells spread over those of even order; without filter {SAMPLED_CELLS} over all that rub",
        threshold="one cell, as sometimes says",
        roles=("both_sides_unequal",),
        measure=one_sided_contact,
    ),
]
