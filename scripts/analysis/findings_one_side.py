"""Findings of the stop on one side."""

from domain_measures import Areas, gap_cells, least_ratio
from finding import (
    HOLDS,
    NOT_REPRODUCED,
    PARTLY,
    SEEN,
    SHARES,
    Finding,
    Outcome,
    figure,
    of_share,
    percent,
    share,
)
from gap_approaches import approaches, decisive
from named_motions import nothing_else, one_of_n, synchronous

ORDERS = (2, 3, 4, 5)
# The orders between which the domains part: a 1/6 domain is cut off by the end of the map.
GAP_ORDERS = (2, 3, 4)
# A column of figure 6, 3 Hz of 30: less than that is not seen to lean.
COLUMN = 0.1
# A hundredth of the axis of the whirl ratio, below which no eye tells two feet apart.
EYE = 0.01
# A casing nearer than that to its place, in clearances, is at rest.
AT_REST = 1e-3
# A trace of a gap goes on for some turns of the free vibration behind the last hit.
LEAST_TURNS, BEHIND = 128, 40


def start_of(n):
    def measure(machine):
        cells = machine.cells("one_side")
        areas, own = Areas(cells), [cell for cell in cells if cell.subharmonic(n)]
        above = areas.share([cell for cell in own if cell.speed > n], own) if own else None
        seen = areas.share(own) > SEEN
        verdict = of_share(above) if seen else PARTLY if of_share(above) == HOLDS else NOT_REPRODUCED
        return Outcome(f"{percent(above)} of {len(own)} cells", verdict)

    return Finding(
        title=f"1: one side: 1/{n} above {n} natural frequencies",
        paper="These vibration occurs in higher speed of n integer multiple of the eigen frequency.",
        counted=f"area of the 1/{n} cells above {n} natural frequencies, of all 1/{n} cells",
        threshold=f"{SHARES}; a domain of less than 1/150 of the map, which no eye sees, holds partly at most",
        reason="the sentence is about a plotted domain, which a stray cell of another one's doubled motion is none of",
        roles=("one_side",),
        measure=measure,
    )


def lean_of(n):
    def measure(machine):
        cells = machine.cells("one_side")
        lean = Areas(cells).lean([cell for cell in cells if cell.subharmonic(n)])
        verdict = NOT_REPRODUCED if lean is None or lean <= 0 else HOLDS if lean >= COLUMN else PARTLY
        return Outcome(f"{figure(lean)} natural frequencies", verdict)

    return Finding(
        title=f"1: one side: 1/{n} moves up in speed with unbalance",
        paper="As the unbalance increases, the 1/n sub harmonic vibration occurs in higher rotating speed.",
        counted=f"natural frequencies from the lowest to the highest row of the 1/{n} cells, along the straight line of "
        "least squares through their speeds over the whirl ratios, by area",
        threshold="holds from 0.1 on, a column of figure 6; partly above 0",
        reason="a lean that is said to be there is seen; one of less than a column is not, whatever its sign",
        roles=("one_side",),
        measure=measure,
    )


def unbalance_of_orders(machine):
    feet = [least_ratio([cell for cell in machine.cells("one_side") if cell.subharmonic(n)]) for n in ORDERS]
    verdict = NOT_REPRODUCED
    if None not in feet:
        steps = [low - high for high, low in zip(feet, feet[1:])]
        if all(step < 0 for step in steps):
            verdict = HOLDS
        elif feet[-1] < feet[0] and max(steps) <= EYE * (1 + 1e-9):
            verdict = PARTLY
    return Outcome(", ".join(map(figure, feet)), verdict)


def motions_of_figure_7(machine):
    row = [cell for cell in machine.cells("one_side") if 0.08 <= cell.ratio <= 0.125]
    counts = [sum(cell.subharmonic(n) for cell in row) for n in (2, 3, 4)]
    shown = sum(count > 0 for count in counts)
    verdict = HOLDS if shown == 3 else PARTLY if shown == 2 else NOT_REPRODUCED
    return Outcome(", ".join(f"{count} of 1/{n}" for n, count in zip((2, 3, 4), counts)) + " cells", verdict)


def gaps_between_domains(machine):
    areas = Areas(machine.cells("one_side"))
    parted = [areas.parted_share(n) for n in GAP_ORDERS]
    least = None if None in parted else min(parted)
    return Outcome(", ".join(map(percent, parted)) + " of the height", of_share(least))


def decisive_approaches(machine):
    """The approach that decides in the middle cell of every gap: the first miss after the last hit."""
    if "decisive" not in machine.memory:
        cells = machine.cells("one_side")
        chosen = [cell for n in GAP_ORDERS for cell in gap_cells(cells, n)]
        config = machine.maps["one_side"]

        def of_cell(cell):
            names = ("t_s", "y_m", "casing_0_y_m", "gap_0_m")
            rows = machine.trajectory("one_side", cell, names, revolutions=max(LEAST_TURNS, cell.last_contact + BEHIND))
            return decisive(approaches(rows, config.number("stops.0.clearance_m"), config.number("kick.duration_s")))

        machine.memory["decisive"] = [one for one in machine.each(of_cell, chosen) if one]
    return machine.memory["decisive"]


def casing_away(machine):
    found = decisive_approaches(machine)
    farthest = max((approach.displacement for approach in found), default=None)
    away = sum(approach.displacement > 1 for approach in found)
    text = f"{away} of {len(found)} approaches, farthest {figure(farthest, 4)} clearances"
    return Outcome(text, of_share(share(away, len(found))))


def casing_moving_away(machine):
    found = decisive_approaches(machine)
    moving = sum(approach.displacement > AT_REST and approach.velocity > 0 for approach in found)
    rest = sum(abs(approach.displacement) <= AT_REST for approach in found)
    text = f"{moving} of {len(found)} approaches, in {rest} it is at rest"
    return Outcome(text, of_share(share(moving, len(found))))


def throws(machine):
    cells = machine.cells("one_side")
    areas, rub = Areas(cells), [cell for cell in cells if cell.rubs()]
    near, far = (areas.share([cell for cell in rub if cell.farthest <= bound], rub) for bound in (5, 10))
    verdict = of_share(near, 0.8, 0.5) if far >= 0.95 else NOT_REPRODUCED
    farthest = max((cell.farthest for cell in rub), default=None)
    return Outcome(f"{percent(near)} within 5, {percent(far)} within 10, farthest {figure(farthest, 1)}", verdict)


GAP_SENTENCE = (
    "In the gap where rubbing vibration is unlikely to occur, the casing is more than clearance away and moving away "
    "from the rotor."
)
GAP_COUNT = (
    "of the middle quiet cell of each gap, row by row, the approach of the rotor that decides, the first miss after the last "
    "hit: how often the casing is then "
)

FINDINGS = [finding(n) for n in ORDERS for finding in (start_of, lean_of)] + [
    Finding(
        title="1: one side: larger n from smaller unbalance",
        paper="As the integer n becomes larger, the 1/n sub harmonic rubbing vibration occurs from smaller unbalance region.",
        counted="least whirl ratio of 1/2, 1/3, 1/4, 1/5",
        threshold="falls from each order to the next; partly where it falls from first to last and rises nowhere by more than "
        "0.01, a hundredth of the axis",
        reason="the sentence is about the feet of the domains; it takes rows that resolve them, which lie between 0.02 and 0.15",
        roles=("one_side",),
        measure=unbalance_of_orders,
    ),
    Finding(
        title="1: one side: the motions of figure 7 at a whirl ratio of 0.1",
        paper="The unbalance amplitude before contact in Figure 7 is set as around 0.1 against the clearance.",
        counted="cells of 1/2, 1/3 and 1/4 at whirl ratios from 0.08 to 0.125",
        threshold="each of the three has one; partly two of them",
        reason="a figure that shows a motion at a whirl ratio says that it is there; around 0.1 is within a factor of 1.25",
        roles=("one_side",),
        measure=motions_of_figure_7,
    ),
    Finding(
        title="1: one side: gaps between the domains",
        paper="The domain of the rubbing vibration occurrence shows a gap.",
        counted="height of the map in which at least a fifth of the cells between the median speeds of 1/n and 1/(n + 1) are "
        "quiet, of the height with both; the least of n = 2, 3, 4",
        threshold=SHARES,
        reason="medians, since one island at the wrong place does not close a gap",
        roles=("one_side",),
        measure=gaps_between_domains,
    ),
    Finding(
        title="1: one side: casing a clearance away in the gaps",
        paper=GAP_SENTENCE,
        counted=GAP_COUNT + "more than a clearance away from its place",
        threshold=SHARES,
        reason="the sentence says why the rotor misses, so that the miss counts and no hit before it",
        roles=("one_side",),
        measure=casing_away,
    ),
    Finding(
        title="1: one side: casing outside of its place and moving away in the gaps",
        paper=GAP_SENTENCE,
        counted=GAP_COUNT + "farther out than 1e-3 clearances and moves outwards",
        threshold=f"{SHARES}; a quarter would be chance",
        reason="its place is the clearance away, so that the sentence may mean outside of it; the sign of the velocity of a "
        "casing at rest is a toss of rounding",
        roles=("one_side",),
        measure=casing_moving_away,
    ),
    nothing_else(
        "1: one side: nothing but 1/n motions", "one_side", (synchronous, one_of_n), "synchronous or 1/2 to 1/7"
    ),
    Finding(
        title="1: one side: the rotor stays near",
        paper="(Implied: a rotor kit was run so.)",
        counted="area of the settled rub that stays within five and ten clearances",
        threshold="80 % within five and 95 % within ten; partly 50 % within five and 95 % within ten",
        reason="a shaft of a kit survives some millimetres; beyond ten no linear shaft would follow",
        roles=("one_side",),
        measure=throws,
    ),
]
