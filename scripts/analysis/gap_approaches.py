"""Where the casing is whenever the rotor comes near it: approaches in one run against a stop above.

An approach is a stretch of time in which the rotor is more than half a clearance up. That of the kick is none.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Approach:
    """The state at the last sample before the contact begins, or without contact at the smallest gap."""

    hit: bool
    displacement: float  # of the casing, away from the rotor, in clearances
    velocity: float  # of the casing, away from the rotor, in clearances per second
    gap: float  # in clearances
    largest: float  # displacement of the casing during the approach


def approaches(samples, clearance_m, kick_s):
    """The approaches in samples (t_s, y_m, casing_y_m, gap_m); one that the run ends in is left out."""
    found = []
    armed = False  # the rotor has been down after the kick
    span = []  # indices of the samples of the approach under way
    samples = list(samples)
    for i in range(1, len(samples) - 1):
        time, y, _, _ = samples[i]
        up = y > 0.5 * clearance_m
        armed = armed or (time > kick_s and not up)
        if armed and up:
            span.append(i)
        elif span:
            found.append(_approach(samples, span, clearance_m))
            span = []
    return found


def until_first_miss(found):
    """The approaches up to the first miss after the last hit: then the rub is over."""
    last_hit = max((i for i, approach in enumerate(found) if approach.hit), default=-1)
    return found[: last_hit + 2]


def decisive(found):
    """The first miss after the last hit, by which the rub is over; None where there is none."""
    last = until_first_miss(found)[-1:]
    return last[0] if last and not last[0].hit else None


def _approach(samples, span, clearance_m):
    # The gap closes at the sample itself or before the next one.
    hits = [i for i in span if samples[i][3] <= 0 or samples[i + 1][3] <= 0]
    i = hits[0] if hits else min(span, key=lambda k: samples[k][3])
    (before, _, casing_before, _), (time, _, casing, gap) = samples[i - 1], samples[i]
    return Approach(
        hit=bool(hits),
        displacement=casing / clearance_m,
        velocity=(casing - casing_before) / (time - before) / clearance_m,
        gap=gap / clearance_m,
        largest=max(0.0, *(samples[k][2] for k in span)) / clearance_m,
    )
