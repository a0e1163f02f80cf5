"""Unbalances of API 617, the response to them, its peaks, and the forces of the bearings."""

import math

import numpy as np

GRAVITY = 9.80665
UNBALANCE_G_MM_RPM_PER_KG = 4 * 6350


def residual_kg_m(mass_kg, speed_hz):
    return UNBALANCE_G_MM_RPM_PER_KG * 1e-6 * mass_kg / (60 * speed_hz)


def major_axis(x, y):
    return abs(x + 1j * y) + abs(x - 1j * y)


class Responses:
    """Response of a rotor to its cases of unbalance, kept by the speed."""

    def __init__(self, rotor, eccentricity_m, highest_hz):
        self.rotor, self.known = rotor, {}
        self.cases = unbalance_cases(rotor, eccentricity_m, highest_hz)
        self.columns = np.array(list(self.cases.values())).T

    def at(self, speed_hz):
        if speed_hz not in self.known:
            w = 2 * math.pi * speed_hz
            mass, damping, stiffness = self.rotor.at(speed_hz)
            self.known[speed_hz] = np.linalg.solve(stiffness - w * w * mass + 1j * w * damping, w * w * self.columns)
        return self.known[speed_hz]

    def axis_m(self, speed_hz, case, position_m):
        x, y = self.rotor.places[self.rotor.place(position_m)]
        motion = self.at(speed_hz)[:, list(self.cases).index(case)]
        return major_axis(motion[x], motion[y])

    def force_n(self, speed_hz, number):
        """Largest force of a support in a turn under the configured unbalance."""
        w, support = 2 * math.pi * speed_hz, self.rotor.supports[number]
        k, c, m = support.at(speed_hz)
        moved = support.gap(self.rotor.n) @ self.at(speed_hz)[:, 0]
        return major_axis(*((k + 1j * w * c - w * w * m) @ moved)) / 2


def one_place(rotor, place, kg_m):
    forces = np.zeros(rotor.n, complex)
    x, y = rotor.places[place]
    forces[x], forces[y] = kg_m, -1j * kg_m
    return forces


def bearing_loads_n(rotor):
    """Static loads of the bearings under the weight, without seals."""
    own = rotor.plane == 1
    _, stiffness = rotor.plane_at_middle(1)
    bearings = rotor.bearings()
    for number, one in enumerate(rotor.supports):
        if rotor.is_seal(number):
            gap = one.gap(rotor.n)[1][own]
            stiffness -= one.at(one.middle_hz)[0][1, 1] * np.outer(gap, gap)
    sag = np.linalg.solve(stiffness, GRAVITY * rotor.weights_kg()[own])
    loads = {}
    for i in bearings:
        one = rotor.supports[i]
        loads[i] = one.at(one.middle_hz)[0][1, 1] * (one.gap(rotor.n)[1][own] @ sag)
    return loads


def unbalance_cases(rotor, eccentricity_m, highest_hz):
    cases = {"configured": eccentricity_m * rotor.unbalance}
    _, shapes = rotor.modes(0)
    in_plane = {freedom: i for i, freedom in enumerate(np.flatnonzero(rotor.plane == 0))}
    bent = shapes[[in_plane[x] for x, _ in rotor.places]]
    first, second = bent[:, 0], bent[:, 1]
    cases["mode 1"] = one_place(rotor, int(np.argmax(abs(first))), residual_kg_m(rotor.mass_kg(), highest_hz))
    bearings, loads = rotor.bearings(), bearing_loads_n(rotor)
    if second.max() > 0 > second.min():
        case = 0
        for place, sign in ((int(np.argmax(second)), 1), (int(np.argmin(second)), -1)):
            nearest = min(bearings, key=lambda i: abs(rotor.supports[i].position_m - rotor.place_m[place]))
            case = case + one_place(rotor, place, sign * residual_kg_m(abs(loads[nearest]) / GRAVITY, highest_hz))
        cases["mode 2"] = case
    ends = {"left end": (0, rotor.mass_kg(high_m=rotor.supports[bearings[0]].position_m)),
            "right end": (-1, rotor.mass_kg(low_m=rotor.supports[bearings[-1]].position_m))}
    for name, (place, mass_kg) in ends.items():
        if mass_kg > 0:
            cases[name] = one_place(rotor, place, residual_kg_m(mass_kg, highest_hz))
    return cases


def top_between(value, low, high):
    """Place and height of the maximum between two places: a golden section, then the zero of the slope."""
    beside = 2e-5
    place, height = golden_section(value, low, high)
    begin, end = place * (1 - 1e-5), place * (1 + 1e-5)

    def slope(hz):
        return value(hz * (1 + beside)) - value(hz * (1 - beside))
    if begin <= low or end >= high or not slope(begin) > 0 > slope(end):
        return place, height
    while end - begin > 1e-12 * end:
        middle = (begin + end) / 2
        begin, end = (middle, end) if slope(middle) > 0 else (begin, middle)
    place = (begin + end) / 2
    return place, max(height, value(place))


def golden_section(value, low, high):
    ratio = (math.sqrt(5) - 1) / 2
    a, b = high - ratio * (high - low), low + ratio * (high - low)
    at_a, at_b = value(a), value(b)
    while high - low > 1e-7 * high:
        if at_a > at_b:
            high, b, at_b = b, a, at_a
            a = high - ratio * (high - low)
            at_a = value(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + ratio * (high - low)
            at_b = value(b)
    return (low + high) / 2, max(at_a, at_b)


def largest(value, speeds_hz):
    """Place and height of the largest value within the range of the speeds."""
    heights = [value(hz) for hz in speeds_hz]
    best = max(range(len(heights)), key=heights.__getitem__)
    top = (speeds_hz[best], heights[best])
    for k in range(1, len(heights) - 1):
        if heights[k] >= max(heights[k - 1], heights[k + 1]) and heights[k] > 0.5 * top[1]:
            found = top_between(value, speeds_hz[k - 1], speeds_hz[k + 1])
            top = max(top, found, key=lambda one: one[1])
    return top


def half_power(value, heights, speeds_hz, peak, k, step):
    """Speed at which the response has fallen to the peak / sqrt 2 on one side; None where it rises above first."""
    level, inner = peak[1] / math.sqrt(2), peak[0]
    while 0 <= k + step < len(speeds_hz):
        k += step
        if heights[k] > peak[1]:
            return None
        if heights[k] < level:
            low, high = inner, speeds_hz[k]  # value(low) > level
            while abs(high - low) > 1e-13 * abs(high):
                middle = (low + high) / 2
                low, high = (middle, high) if value(middle) > level else (low, middle)
            return (low + high) / 2
        inner = speeds_hz[k]
    return None


def peaks(value, speeds_hz):
    """Speed, height and amplification factor (None where it has none) of every peak."""
    heights = [value(hz) for hz in speeds_hz]
    found = []
    for k in range(1, len(heights) - 1):
        if not (heights[k] > heights[k - 1] and heights[k] >= heights[k + 1]):
            continue
        peak = top_between(value, speeds_hz[k - 1], speeds_hz[k + 1])
        low, high = (half_power(value, heights, speeds_hz, peak, k, step) for step in (-1, 1))
        if low and high:
            found.append((*peak, peak[0] / (high - low)))
        elif low or high:
            found.append((*peak, peak[0] / (2 * abs(peak[0] - (low or high)))))
        else:
            found.append((*peak, None))
    return found


def separations(amplification, peak_hz, from_hz, to_hz):
    """Actual and required separation of a peak from the range, as shares of its nearer end."""
    actual = max(1 - peak_hz / from_hz, peak_hz / to_hz - 1)
    if amplification is None:
        return actual, None
    if amplification < 2.5:
        return actual, 0.0
    share = 0.17 * (1 - 1 / (amplification - 1.5))
    above = to_hz - peak_hz < peak_hz - from_hz
    return actual, min(0.26, 0.10 + share) if above else min(0.16, share)
