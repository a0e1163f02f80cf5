#!/usr/bin/env python3
"""run_up_by_amplitude.py TABLE.csv [RATE_HZ_PER_S]: one mode on an even ramp beside the amplitudes of a measured 1X.

TABLE.csv has the columns rpm and um, rows in the order of the run-up. Frequency and damping ratio of the mode, the rate
unless it is given, and the unbalance are fitted to the amplitudes alone; the phases are not looked at. The mode is
integrated by Runge-Kutta steps in the frame that turns with the shaft, from 0.8 of the first speed.
"""

import csv
import math
import sys

STEP_S = 1 / 300


def read(path):
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return [float(row["rpm"]) / 60 for row in rows], [float(row["um"]) for row in rows]


def amplitudes(speeds_hz, frequency_hz, ratio, rate):
    """Amplitudes of the mode for an eccentricity of 1 where the ramp reaches each speed."""
    p = 2 * math.pi * frequency_hz * complex(-ratio, math.sqrt(1 - ratio * ratio))
    values = (p, p.conjugate())
    shares = (1 / (p - p.conjugate()), 1 / (p.conjugate() - p))
    from_hz = 0.8 * speeds_hz[0]
    turn = lambda t: 2 * math.pi * (from_hz + rate * t)
    push = lambda t: turn(t) ** 2 - 2j * math.pi * rate
    slope = lambda t, a: [(v - 1j * turn(t)) * x + s * push(t) for v, s, x in zip(values, shares, a)]
    moved = lambda a, h, k: [x + h * y for x, y in zip(a, k)]
    state, t, found = [-s * push(0) / (v - 1j * turn(0)) for v, s in zip(values, shares)], 0.0, []
    for speed in speeds_hz:
        end = (speed - from_hz) / rate
        steps = max(1, math.ceil((end - t) / STEP_S))
        h = (end - t) / steps
        for _ in range(steps):
            k1 = slope(t, state)
            k2 = slope(t + h / 2, moved(state, h / 2, k1))
            k3 = slope(t + h / 2, moved(state, h / 2, k2))
            k4 = slope(t + h, moved(state, h, k3))
            state = [x + h / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in zip(state, k1, k2, k3, k4)]
            t += h
        found.append(abs(sum(state)))
    return found


def left_um(speeds_hz, measured_um, numbers):
    model = amplitudes(speeds_hz, *numbers)
    scale = sum(a * b for a, b in zip(model, measured_um)) / sum(a * a for a in model)
    return math.sqrt(sum((scale * a - b) ** 2 for a, b in zip(model, measured_um)) / len(model))


def least(function, start, steps):
    """The downhill simplex of Nelder and Mead."""
    points = [(function(start), list(start))]
    for i, step in enumerate(steps):
        moved = [x + (step if i == j else 0) for j, x in enumerate(start)]
        points.append((function(moved), moved))
    count = len(start)
    for _ in range(80):
        points.sort()
        worst = points[-1][1]
        centre = [sum(point[i] for _, point in points[:-1]) / count for i in range(count)]
        at = lambda share: [c + share * (c - w) for c, w in zip(centre, worst)]
        tried = [(function(at(1)), at(1))]
        if tried[0][0] < points[0][0]:
            tried.append((function(at(2)), at(2)))
        elif tried[0][0] >= points[-2][0]:
            tried = [(function(at(-0.5)), at(-0.5))]
        if min(tried)[0] < points[-1][0]:
            points[-1] = min(tried)
        else:
            best = points[0][1]
            shrunk = [[(x + y) / 2 for x, y in zip(best, point)] for _, point in points[1:]]
            points = [points[0]] + [(function(point), point) for point in shrunk]
    return min(points)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    speeds_hz, measured_um = read(sys.argv[1])
    fixed = [float(text) for text in sys.argv[2:]]
    highest = speeds_hz[measured_um.index(max(measured_um))]
    start = [0.95 * highest, 0.012] + ([] if fixed else [4.0])
    left, found = least(lambda numbers: left_um(speeds_hz, measured_um, [*numbers, *fixed]), start, [0.2, 0.002, 0.3][: len(start)])
    frequency_hz, ratio, rate = [*found, *fixed]
    size = math.sqrt(sum(value**2 for value in measured_um) / len(measured_um))
    print(f"{frequency_hz:.2f} Hz, damping ratio {ratio:.4f}, {rate:.2f} Hz/s: leaves {left:.2f} um of {size:.2f} um")


if __name__ == "__main__":
    main()
