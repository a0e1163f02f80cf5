"""Findings of the annulus, centred and with offset."""

import statistics

from domain_measures import (
    hits_per_whirl,
    highest_speed,
    least_ratio,
    lowest_speed,
    row_tops,
    rows_reaching_higher,
)
from finding import HOLDS, NOT_REPRODUCED, PARTLY, SHARES, Finding, Outcome, figure, of_share, percent, share
from oval_shape import ellipse
from rubplot.evenly_spread import spread

SAMPLED_OVALS = 24


def circles(machine, role):
    return [cell for cell in machine.cells(role) if cell.synchronous_circle()]


def ovals(machine):
    return [cell for cell in machine.cells("annulus") if cell.oval()]


def middle_speed(cells):
    return statistics.median(cell.speed for cell in cells) if cells else None


def speeds(cells):
    text = f"{len(cells)} cells"
    if cells:
        text += f", {figure(lowest_speed(cells), 1)} to {figure(highest_speed(cells), 1)}, median {figure(middle_speed(cells), 1)}"
    return text


def circle_at_low_speed(machine):
    found, others = circles(machine, "annulus"), ovals(machine)
    verdict = NOT_REPRODUCED
    if found and (not others or highest_speed(found) < middle_speed(others)):
        verdict = HOLDS
    elif found and middle_speed(found) < middle_speed(others):
        verdict = PARTLY
    unfiltered = [cell for cell in machine.cells("annulus") if cell.name == "synchronous"]
    return Outcome(speeds(found), speeds(unfiltered), verdict)


def oval_at_high_speed(machine):
    found, low = ovals(machine), circles(machine, "annulus")
    synchronous = [cell for cell in machine.cells("annulus") if cell.name == "synchronous" and cell.orbit == "oval"]
    above = not low or (found and middle_speed(found) > highest_speed(low))
    verdict = NOT_REPRODUCED
    if synchronous and (not low or middle_speed(synchronous) > highest_speed(low)):
        verdict = HOLDS
    elif found and above:
        verdict = PARTLY
    measured = f"{len(synchronous)} synchronous ovals; quasi-periodic ones: {speeds(found)}"
    rubbing = [cell for cell in machine.cells("annulus") if cell.rubs() and not cell.synchronous_circle()]
    return Outcome(measured, f"all that rub but circles: {speeds(rubbing)}", verdict)


def oval_unbalance(machine):
    oval, circle = least_ratio(ovals(machine)), least_ratio(circles(machine, "annulus"))
    smaller = oval is not None and (circle is None or oval < circle)
    text = f"oval from {figure(oval)}, circle from {figure(circle)}"
    return Outcome(text, "the same", HOLDS if smaller else NOT_REPRODUCED)


def oval_is_oval(machine):
    chosen = spread(ovals(machine), SAMPLED_OVALS)
    shapes = [shape for shape in machine.each(lambda cell: ellipse(machine.spectrum("annulus", cell)), chosen) if shape]
    good = [shape for shape in shapes if shape.nearly_closed_oval()]

    def axes(found):
        return f"axes {figure(min(s.axes for s in found))} to {figure(max(s.axes for s in found))} : 1" if found else "none"

    turning = max((abs(shape.precession) for shape in shapes), default=None)
    unfiltered = f"all {len(chosen)}: {axes(shapes)}, turning by up to {figure(turning)} per revolution"
    return Outcome(f"{len(good)} of {len(chosen)} sampled cells, {axes(good)}", unfiltered, of_share(share(len(good), len(chosen))))


def oval_hits(machine):
    hits = [hits_per_whirl(cell) for cell in ovals(machine)]
    several = sum(count > 1.5 for count in hits)
    middle = figure(statistics.median(hits) if hits else None, 1)
    measured = f"{percent(several, len(hits))} of {len(hits)} cells"
    return Outcome(measured, f"median of all: {middle} hits", of_share(share(several, len(hits))))


def wider_circle(machine, gap_share):
    cells, other = circles(machine, "annulus_offset"), circles(machine, "annulus")
    ratios, other_ratios = machine.ratios("annulus_offset"), machine.ratios("annulus")
    higher, rows = rows_reaching_higher(row_tops(cells), row_tops(other), ratios, other_ratios, gap_share)
    tops = f"up to {figure(highest_speed(cells), 1)}, centred up to {figure(highest_speed(other), 1)}"
    return Outcome(f"higher in {higher} of {rows} rows", tops, of_share(share(higher, rows)))


def wider_at_same_ratio(machine):
    return wider_circle(machine, 1.0)


def wider_at_same_unbalance(machine):
    return wider_circle(machine, machine.maps["annulus_offset"].gap_share())


def subharmonics_above_multiples(machine):
    texts, unfiltered, lowest_slightly, most_slightly = [], [], True, True
    for n in (2, 3):
        cells = [cell for cell in machine.cells("annulus_offset") if cell.subharmonic(n)]
        lowest = lowest_speed(cells)
        slightly = sum(n < cell.speed < n + 0.5 for cell in cells)
        texts.append(f"1/{n} from {figure(lowest)}")
        unfiltered.append(f"{slightly} of {len(cells)} 1/{n} cells below {n}.5")
        lowest_slightly &= lowest is not None and n < lowest < n + 0.5
        most_slightly &= of_share(share(slightly, len(cells))) == HOLDS
    verdict = NOT_REPRODUCED
    if lowest_slightly:
        verdict = HOLDS if most_slightly else PARTLY
    return Outcome(", ".join(texts), ", ".join(unfiltered), verdict)


def another_circle(machine):
    def small(role):
        clearance_m = machine.maps[role].number("stops.0.clearance_m")
        return sum(cell.amplitude_1x_m < clearance_m for cell in circles(machine, role))

    offset, centred = small("annulus_offset"), small("annulus")
    verdict = NOT_REPRODUCED
    if offset:
        verdict = PARTLY if centred else HOLDS
    total = f"{len(circles(machine, 'annulus_offset'))} and {len(circles(machine, 'annulus'))} circles of any size"
    return Outcome(f"{offset} with offset, {centred} centred", total, verdict)


WIDER = (
    "In comparison with the domain without the offset, the synchronous circle rotor orbit vibration occurs in the wider "
    "rotating speed range toward high rotating speed."
)

FINDINGS = [
    Finding(
        title="3: annulus: synchronous circle at low speed",
        paper="In the low rotating speed range, synchronous circle rotor orbit vibration occurs.",
        counted="speeds over the natural frequency",
        cells="synchronous circles; without filter all synchronous cells",
        threshold="the highest lies below the median of the ovals, since low and high are said of these two; partly where "
        "only its median does",
        roles=("annulus",),
        measure=circle_at_low_speed,
    ),
    Finding(
        title="3: annulus: oval whirl at high speed (quasi-periodic in space, closed in the rotating frame)",
        paper="In the high rotating speed range, synchronous oval rotor orbit vibration occurs from the small unbalance "
        "region.",
        counted="synchronous ovals; ovals that are quasi-periodic in space and closed in the rotating frame, which are not "
        "synchronous: their lines are 1 + k spacing with a spacing that has no ratio to the speed",
        cells="synchronous cells with an oval orbit; quasi-periodic cells with a comb",
        threshold="synchronous ovals whose median is above the highest circle; partly where only quasi-periodic ones are",
        roles=("annulus",),
        measure=oval_at_high_speed,
    ),
    Finding(
        title="3: annulus: the quasi-periodic oval from smaller unbalance than the circle",
        paper="In the high rotating speed range, synchronous oval rotor orbit vibration occurs from the small unbalance "
        "region.",
        counted="least whirl ratio",
        cells="quasi-periodic ovals and synchronous circles, no filter",
        threshold="less than that of the circle, the other domain of the same figure",
        roles=("annulus",),
        measure=oval_unbalance,
    ),
    Finding(
        title="3: annulus: the whirl is an oval, turning in space",
        paper="the other is the oval rotor orbit shown in Figure 10.",
        counted="ellipses of the two largest lines off 1X, flatter than 0.9 : 1 (to be told from circles), turning by less "
        "than 0.1 per revolution (to be seen as ovals), with 80 % of the energy (to be ellipses)",
        cells=f"{SAMPLED_OVALS} cells spread over the quasi-periodic ovals; without filter the same without these bounds",
        threshold=SHARES,
        roles=("annulus",),
        measure=oval_is_oval,
    ),
    Finding(
        title="3: annulus: the oval hits several times per whirl",
        paper="the rotor collides with the casing several times per one whirling period.",
        counted="cells with more than 1.5 hits per whirl: most of their whirls see two or more",
        cells="all quasi-periodic ovals",
        threshold=SHARES,
        roles=("annulus",),
        measure=oval_hits,
    ),
    Finding(
        title="4: offset: circle to higher speed, same whirl ratio",
        paper=WIDER,
        counted="rows of the whirl ratio whose circles reach higher speed than centred; without filter the highest of all",
        cells="synchronous circles of both maps",
        threshold=SHARES,
        roles=("annulus", "annulus_offset"),
        measure=wider_at_same_ratio,
    ),
    Finding(
        title="4: offset: circle to higher speed, same unbalance",
        paper=WIDER,
        counted="the same against the rows of the same unbalance in the centred map, both of them where it lies between two",
        cells="synchronous circles of both maps",
        threshold=SHARES,
        roles=("annulus", "annulus_offset"),
        measure=wider_at_same_unbalance,
    ),
    Finding(
        title="4: offset: subharmonics slightly above n",
        paper="The sub harmonic vibration occurs in the slightly higher rotating speed of the n integer multiple of the "
        "eigen frequency.",
        counted="lowest speed over the natural frequency; without filter the cells between n and n + 0.5",
        cells="1/2 and 1/3 cells",
        threshold="for both n the lowest between n and n + 0.5, nearer to n than to n + 1, and 90 % of the cells; partly "
        "the lowest alone",
        roles=("annulus_offset",),
        measure=subharmonics_above_multiples,
    ),
    Finding(
        title="4: offset: another kind of synchronous circle",
        paper="the sub harmonic and the other kind of the synchronous circle rotor orbit vibration occur.",
        counted="circles smaller than the clearance: the casing moves against the rotor",
        cells="synchronous circles of both maps",
        threshold="some with offset, none without: the paper has it with offset only; partly where both have some",
        roles=("annulus", "annulus_offset"),
        measure=another_circle,
    ),
]
