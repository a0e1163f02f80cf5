"""Whirl of a rotor: modes at a speed, logarithmic decrements, critical speeds, threshold of cross-coupling."""

import math

import numpy as np


def polished(matrices, root, shape):
    """Root and shape of (root^2 M + root C + K) shape = 0 by inverse iteration on the nonlinear problem."""
    mass, damping, stiffness = matrices
    shape = shape / np.linalg.norm(shape)
    for _ in range(12):
        norm = shape.conj()
        step = np.linalg.solve(root * root * mass + root * damping + stiffness, (2 * root * mass + damping) @ shape)
        change = (norm @ shape) / (norm @ step)
        shape = step / np.linalg.norm(step)
        root = root - change
        if abs(change) < 1e-12 * abs(root):
            break
    return root, shape


def roots_of(matrices):
    """Whirl (root, shape) at one speed, slowest first."""
    mass, damping, stiffness = matrices
    n = len(mass)
    slow = np.zeros((2 * n, 2 * n))
    slow[:n, :n], slow[:n, n:] = -np.linalg.solve(stiffness, damping), -np.linalg.solve(stiffness, mass)
    slow[n:, :n] = np.eye(n)
    values, vectors = np.linalg.eig(slow)
    good = abs(values) > 1e-12 * abs(values).max()
    rates, shapes = 1 / values[good], vectors[:n, good].T
    found = [(rate, shape) for rate, shape in zip(rates, shapes) if rate.imag > 1e-7 * abs(rate)]
    return sorted(found, key=lambda one: one[0].imag)


def damping_ratio(root):
    return -root.real / abs(root)


def forward_share(rotor, mass, shape):
    """Share of the forward whirl in the squares of the motion, weighed by the mean mass of both planes."""
    pairs = np.array(rotor.places + rotor.housings)
    tilts = rotor.tilts
    x = np.concatenate([pairs[:, 0], tilts[:, 0]])
    y = np.concatenate([pairs[:, 1], tilts[:, 1]])
    sign = np.concatenate([np.ones(len(pairs)), -np.ones(len(tilts))])
    mean = (mass[np.ix_(x, x)] + mass[np.ix_(y, y)] * np.outer(sign, sign)) / 2
    forward = shape[x] + 1j * sign * shape[y]
    backward = shape[x] - 1j * sign * shape[y]
    both = [(one.conj() @ mean @ one).real for one in (forward, backward)]
    return both[0] / sum(both)


def coupled(rotor, matrices, place, coupling_n_per_m):
    mass, damping, stiffness = matrices
    x, y = rotor.places[place]
    stiffness = stiffness.copy()
    stiffness[x, y] += coupling_n_per_m
    stiffness[y, x] -= coupling_n_per_m
    return mass, damping, stiffness


def first_forward(rotor, matrices, up_to_hz):
    """First forward whirl that is damped by less than half of critical; None where there is none."""
    for root, shape in roots_of(matrices):
        if root.imag > 2 * math.pi * up_to_hz:
            return None
        if damping_ratio(root) < 0.5 and forward_share(rotor, rotor.mass, shape) > 0.5:
            return polished(matrices, root, shape)
    return None


def decrement(root):
    return -2 * math.pi * root.real / root.imag


def threshold_n_per_m(rotor, matrices, place, up_to_hz):
    """Cross-coupling at which the first forward whirl neither grows nor decays."""
    mode = first_forward(rotor, matrices, up_to_hz)
    if mode is None:
        return None
    low, high = (0.0, mode), None
    coupling = 1e4
    while high is None:
        grown = polished(coupled(rotor, matrices, place, coupling), *low[1])
        if grown[0].real > 0:
            high = (coupling, grown)
        else:
            low, coupling = (coupling, grown), 1.5 * coupling
            if coupling > 1e12:
                return None
    while high[0] - low[0] > 1e-12 * high[0]:
        middle = (low[0] + high[0]) / 2
        if middle in (low[0], high[0]):
            break
        found = (middle, polished(coupled(rotor, matrices, place, middle), *low[1]))
        low, high = (low, found) if found[1][0].real > 0 else (found, high)
    return (low[0] + high[0]) / 2


def rigid_critical_hz(rotor):
    """First critical speed of synchronous forward whirl in Hz, without seals, with the shaft pinned at its bearings to the
    ground or to the housings on which they stand."""
    mass, stiffness = rotor.mass.copy(), rotor.stiffness.copy()
    for one in rotor.supports:
        if one.position_m is not None and not one.tabled:
            k, _, m = one.at(0)
            gap = one.gap(rotor.n)
            stiffness -= gap.T @ k @ gap
            mass -= gap.T @ m @ gap
    points, tilts = np.array(rotor.places + rotor.housings), rotor.tilts
    x, y = (np.concatenate([points[:, plane], tilts[:, plane]]) for plane in range(2))
    sign = np.concatenate([np.ones(len(points)), -np.ones(len(tilts))])
    both = np.outer(sign, sign)
    # y = -i x and y' = w x: the gyroscopic force w G y' is w^2 G x.
    inertia = (mass[np.ix_(x, x)] + both * mass[np.ix_(y, y)]) / 2 - rotor.gyroscopic[np.ix_(x, y)] * sign
    spring = (stiffness[np.ix_(x, x)] + both * stiffness[np.ix_(y, y)]) / 2
    free = np.eye(len(x))
    for i in rotor.bearings():
        here, base = (None if at is None else list(x).index(at) for at in rotor.supports[i].pairs[0])
        free[here] = 0 if base is None else free[base]
    free = free[:, free.any(axis=0)]
    values = np.linalg.eigvals(np.linalg.solve(free.T @ spring @ free, free.T @ inertia @ free))
    return 1 / (2 * math.pi * math.sqrt(values.real.max()))


def region_limit(density_kg_per_m3):
    """Critical speed ratio between the regions A and B of Level I."""
    if density_kg_per_m3 > 60:
        return 0.0
    return 2.5 if density_kg_per_m3 <= 16.53 else 2.69 - 0.0115 * density_kg_per_m3


def critical_speeds(rotor, from_hz, to_hz, anchors=4, steps=20):
    """Speeds at which a whirl frequency equals the shaft speed, with damping ratio: modes are found at some speeds
    and followed between them."""
    found = []
    grid = np.linspace(from_hz, to_hz, (anchors - 1) * steps + 1)
    for anchor in range(anchors):
        start = anchor * steps
        for root, shape in roots_of(rotor.at(grid[start])):
            if root.imag > 4 * math.pi * to_hz:
                break
            for step in (-1, 1):
                follow(rotor, grid, start, step, steps, root, shape, found)
    unique = []
    for one in sorted(found):
        if not unique or one[0] - unique[-1][0] > 1e-7 * one[0]:
            unique.append(one)
    return unique


def follow(rotor, grid, start, step, steps, root, shape, found):
    last_hz = grid[start]
    for k in range(start + step, start + step * (steps + 1), step):
        if not 0 <= k < len(grid):
            return
        new_root, new_shape = polished(rotor.at(grid[k]), root, shape)
        alike = abs(new_shape.conj() @ shape) / np.linalg.norm(shape) / np.linalg.norm(new_shape)
        if alike < 0.5 or new_root.imag <= 1e-7 * abs(new_root):
            return
        before, after = root.imag / (2 * math.pi) - last_hz, new_root.imag / (2 * math.pi) - grid[k]
        if before * after < 0:
            low, high, mode = last_hz, grid[k], (root, shape)
            for _ in range(60):
                middle = (low + high) / 2
                mode = polished(rotor.at(middle), *mode)
                excess = mode[0].imag / (2 * math.pi) - middle
                low, high = (middle, high) if excess * before > 0 else (low, middle)
                if abs(high - low) < 1e-13 * abs(high):
                    break
            found.append(((low + high) / 2, damping_ratio(mode[0])))
        root, shape, last_hz = new_root, new_shape, grid[k]
