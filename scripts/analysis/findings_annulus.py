"""Findings of the annulus, centred and with offset."""

import statistics

from domain_measures import Areas, gains, hits_per_whirl, highest_speed, least_ratio, lowest_speed, row_tops
from finding import (
    HOLDS,
    NOT_REPRODUCED,
    PARTLY,
    SEEN,
    SHARES,
    Finding,
    Outcome,
    figure,
    of_both,
    of_share,
    percent,
    share,
)
from named_motions import nothing_else, one_of_n, quasi_periodic, synchronous
from oval_shape import ellipse
from rubplot.evenly_spread import spread

SAMPLED_OVALS = 24
# Slightly above n is nearer to n than to n + 1.
SLIGHTLY = 0.5


def circles(machine, role):
    return [cell for cell in machine.cells(role) if cell.synchronous_circle()]


def ovals(machine):
    """Synchronous ones and combs."""
    return [cell for cell in machine.cells("annulus") if cell.oval() or cell.synchronous_oval()]


def combs(machine):
    return [cell for cell in machine.cells("annulus") if cell.oval()]


def middle_speed(cells):
    return statistics.median(cell.speed for cell in cells) if cells else None


def speeds(cells):
    text = f"{len(cells)} cells"
    if cells:
        text += f", {figure(lowest_speed(cells), 1)} to {figure(highest_speed(cells), 1)}"
    return text


def circle_at_low_speed(machine):
    found, whole = circles(machine, "annulus"), machine.cells("annulus")
    middle = middle_speed(ovals(machine) or whole)
    low = Areas(whole).share([cell for cell in found if cell.speed <= middle], found) if found else None
    return Outcome(f"{percent(low)} of {speeds(found)}, up to {figure(middle, 1)}", of_share(low))


def oval_at_high_speed(machine):
    found, low = ovals(machine), circles(machine, "annulus")
    locked = [cell for cell in found if cell.synchronous_oval()]
    areas = Areas(machine.cells("annulus"))
    above = found and (not low or middle_speed(found) > middle_speed(low))
    verdict = NOT_REPRODUCED
    if above:
        verdict = HOLDS if areas.share(locked, found) >= 0.5 else PARTLY
    median = f"median {figure(middle_speed(found), 1)}, of the circles {figure(middle_speed(low), 1)}"
    return Outcome(f"{len(locked)} synchronous of {len(found)} ovals, {median}", verdict)


def oval_unbalance(machine):
    oval, circle = least_ratio(ovals(machine)), least_ratio(circles(machine, "annulus"))
    smaller = oval is not None and (circle is None or oval < circle)
    return Outcome(f"oval from {figure(oval)}, circle from {figure(circle)}", HOLDS if smaller else NOT_REPRODUCED)


def oval_is_oval(machine):
    chosen = spread(combs(machine), SAMPLED_OVALS)
    shapes = [shape for shape in machine.each(lambda cell: ellipse(machine.spectrum("annulus", cell)), chosen) if shape]
    good = [shape for shape in shapes if shape.nearly_closed_oval()]
    text = f"{len(good)} of {len(chosen)} cells"
    if shapes:
        turning = statistics.median(abs(shape.precession) for shape in shapes)
        text += f", turning by {figure(turning)} per revolution in the median"
    if good:
        text += f", axes {figure(min(s.axes for s in good))} to {figure(max(s.axes for s in good))} : 1"
    return Outcome(text, of_share(share(len(good), len(chosen)) if chosen else None))


def oval_hits(machine):
    found = combs(machine)
    hits = [hits_per_whirl(cell) for cell in found]
    several = [cell for cell, count in zip(found, hits) if count > 1.5]
    of_area = Areas(machine.cells("annulus")).share(several, found) if found else None
    middle = figure(statistics.median(hits) if hits else None, 1)
    return Outcome(f"{percent(of_area)} of {len(found)} cells, median {middle} hits", of_share(of_area))


def wider_circle(machine):
    offset, centred = circles(machine, "annulus_offset"), circles(machine, "annulus")
    lowest = lowest_speed(machine.cells("annulus"))
    found = gains(row_tops(offset), row_tops(centred), machine.ratios("annulus_offset"), machine.ratios("annulus"),
                  machine.maps["annulus_offset"].gap_share(), lowest)
    if not found:
        return Outcome("no circle", NOT_REPRODUCED)
    higher, mean = sum(gain > 1e-9 for gain in found), statistics.mean(found)
    wide = mean >= Areas(machine.cells("annulus_offset")).column / 2
    text = f"higher in {higher} of {len(found)} rows, by {mean:+.2f} natural frequencies on the mean"
    return Outcome(text, of_both(wide, higher >= 0.5 * len(found)))


def subharmonics_above_multiples(machine):
    cells = machine.cells("annulus_offset")
    found = [cell for cell in cells if cell.subharmonic() and cell.order <= 5]
    slightly = [cell for cell in found if 0 < cell.speed - cell.order < SLIGHTLY]
    verdict = of_share(Areas(cells).share(slightly, found)) if len(slightly) >= 2 else NOT_REPRODUCED
    lowest = ", ".join(
        f"1/{n} from {figure(lowest_speed([cell for cell in found if cell.subharmonic(n)]))}" for n in (2, 3)
    )
    return Outcome(f"{len(slightly)} of {len(found)} cells; {lowest}", verdict)


def is_other_circle(cell, clearance_m):
    return cell.synchronous_circle() and (cell.contact_fraction < 0.5 or cell.amplitude_1x_m < clearance_m)


def another_circle(machine):
    clearance_m = machine.maps["annulus_offset"].number("stops.0.clearance_m")
    found, others, centred = (
        circles(machine, "annulus_offset"),
        [cell for cell in machine.cells("annulus_offset") if is_other_circle(cell, clearance_m)],
        [cell for cell in machine.cells("annulus") if is_other_circle(cell, clearance_m)],
    )
    pressed = [cell for cell in found if cell.contact_fraction > 0.999]
    verdict, areas = NOT_REPRODUCED, Areas(machine.cells("annulus_offset"))
    if others and pressed and areas.share(others) > SEEN:
        verdict = PARTLY if centred else HOLDS
    text = f"{len(others)} others beside {len(pressed)} in contact all along; centred {len(centred)} others"
    return Outcome(text, verdict)


WIDER = (
    "In comparison with the domain without the offset, the synchronous circle rotor orbit vibration occurs in the wider "
    "rotating speed range toward high rotating speed."
)
HIGH_SPEED = (
    "In the high rotating speed range, synchronous oval rotor orbit vibration occurs from the small unbalance region."
)
CIRCLE = "a circle is a synchronous cell whose -1X is a tenth of +1X at most, so that its axes are within 1.22 : 1 to the eye"

FINDINGS = [
    Finding(
        title="3: annulus: synchronous circle at low speed",
        paper="In the low rotating speed range, synchronous circle rotor orbit vibration occurs.",
        counted="area of the circles up to the median speed of the ovals (of the map, where there are none)",
        threshold=SHARES,
        reason="low and high are said of these two; " + CIRCLE,
        roles=("annulus",),
        measure=circle_at_low_speed,
    ),
    Finding(
        title="3: annulus: synchronous oval at high speed",
        paper=HIGH_SPEED,
        counted="synchronous cells that are ellipses and no circles, and combs whose -1X turns by less than a tenth of a turn "
        "per revolution; of these and all other combs",
        threshold="half of the ovals or more, which lie higher than the circles by their medians; partly where the ovals that "
        "do are not synchronous",
        reason="the paper may have seen by eye that it is synchronous, so that slow turning counts as such",
        roles=("annulus",),
        measure=oval_at_high_speed,
    ),
    Finding(
        title="3: annulus: the oval from smaller unbalance than the circle",
        paper=HIGH_SPEED,
        counted="least whirl ratio of ovals and circles",
        threshold="less than that of the circle",
        reason="small is said beside the other domain of the same figure",
        roles=("annulus",),
        measure=oval_unbalance,
    ),
    Finding(
        title="3: annulus: the whirl is an oval, turning in space",
        paper="the other is the oval rotor orbit shown in Figure 10.",
        counted=f"of {SAMPLED_OVALS} cells spread over the combs, ellipses of the two largest lines off 1X, flatter than "
        "0.9 : 1 (to be told from circles), turning by less than 0.1 per revolution (to be seen as ovals), with 80 % of the "
        "energy (to be ellipses)",
        threshold=SHARES,
        reason="what makes it an oval to the eye, of a motion that is not synchronous",
        roles=("annulus",),
        measure=oval_is_oval,
    ),
    Finding(
        title="3: annulus: the oval hits several times per whirl",
        paper="the rotor collides with the casing several times per one whirling period.",
        counted="area of the combs with more than 1.5 hits per whirl: most of their whirls see two or more",
        threshold=SHARES,
        reason="several is two or more",
        roles=("annulus",),
        measure=oval_hits,
    ),
    nothing_else(
        "3: annulus: nothing but circle and oval",
        "annulus",
        (synchronous, quasi_periodic),
        "synchronous or quasi-periodic",
    ),
    Finding(
        title="4: offset: circle to higher speed",
        paper=WIDER,
        counted="by how much the highest circle of a row lies above that of the centred map at the same eccentricity, over the "
        "rows with a circle in either",
        threshold="half a column of the map on the mean, and half of the rows higher; partly one of the two",
        reason="wider is said of the domain, so that not every row has to be; the ordinate shows unbalance; " + CIRCLE,
        roles=("annulus", "annulus_offset"),
        measure=wider_circle,
    ),
    Finding(
        title="4: offset: subharmonics slightly above n",
        paper="The sub harmonic vibration occurs in the slightly higher rotating speed of the n integer multiple of the "
        "eigen frequency.",
        counted="area of the 1/2 to 1/5 cells between n and n + 0.5, of all of them",
        threshold=f"{SHARES}; with two such cells at least",
        reason="the sentence names no n; slightly above n is nearer to n than to n + 1",
        roles=("annulus_offset",),
        measure=subharmonics_above_multiples,
    ),
    Finding(
        title="4: offset: another kind of synchronous circle",
        paper="the sub harmonic and the other kind of the synchronous circle rotor orbit vibration occur.",
        counted="circles that touch for less than half of the time, or are smaller than the clearance, beside those in contact "
        "all along",
        threshold="both kinds, the other one in more than 1/150 of the map, and none of it centred; partly where the centred map has the other kind, too",
        reason="the paper does not say what is other about it; these are the kinds that the eye tells apart",
        roles=("annulus", "annulus_offset"),
        measure=another_circle,
    ),
    nothing_else(
        "4: offset: nothing but synchronous, 1/n and oval motions",
        "annulus_offset",
        (synchronous, one_of_n, quasi_periodic),
        "synchronous, 1/2 to 1/7 or quasi-periodic",
    ),
]
