"""Rotors with two bending modes, a rub or a foreign cause, integrated by NumPy for many recordings at once.

The equations share no code, contact law or integrator with the library:

- contact force K d^n (1 + a d') without pull (Hunt and Crossley), n from 1 to 1.5, on a rigid wall or on a casing
  with a mass, spring and damper of its own;
- friction mu tanh(slip / slip scale) times the normal force;
- two modes, whose stiffness differs by up to 2 % between x and y;
- a speed that wanders about its mean (an Ornstein-Uhlenbeck process), and may run up or down;
- classical Runge-Kutta steps, 1024 a turn.

Displacements z = x + iy are in units of the clearance, times in seconds. Every array has one entry for each
recording.
"""

import numpy as np

STEPS = 1024
RUBS = ("one_side", "two_sides", "annular", "annular_offset")
FOREIGN = ("misalignment", "cracked_shaft", "loose_support", "oil_whirl", "bearing_fault", "run_out",
           "clipped_probe", "mains_hum")


def along(direction, z):
    """Component of z along a direction of length 1."""
    return (z * np.conj(direction)).real


class Rotors:
    """Forces of all rotors; `p` holds their numbers, see independent_recordings.draw."""

    def __init__(self, p, random):
        self.p, self.random = p, random
        self.kind = {name: p["cause"] == name for name in RUBS + FOREIGN} | {"misalignment": p["misaligned"]}
        self.normal = np.exp(1j * p["angle"])
        self.flat = self.kind["one_side"] | self.kind["two_sides"]
        self.round = self.kind["annular"] | self.kind["annular_offset"]
        self.touching = self.flat | self.round
        self.last_impact = np.zeros(len(p["cause"]))

    def wall(self, normal, depth, velocity):
        """Force of a wall on the rotor; `velocity` is that of the rotor against the wall."""
        p, deep = self.p, np.maximum(depth, 0)
        force = p["hardness"] * deep ** p["exponent"] * np.maximum(0, 1 + p["loss"] * along(normal, velocity))
        slip = along(1j * normal, velocity) + p["rim_speed"]
        return -force * normal * (1 + 1j * p["friction"] * np.tanh(slip / (0.01 * p["rim_speed"])))

    def contact(self, z, velocity):
        """Force of the stops on the rotor; place and velocity are those against the casing."""
        p, n = self.p, self.normal
        reach = along(n, z)
        flat = self.wall(n, reach - 1, velocity)
        second = self.wall(-n, -reach - p["second_clearance"], velocity)
        from_centre = z - p["offset"] * n
        distance = np.maximum(np.abs(from_centre), 1e-12)
        ring = self.wall(from_centre / distance, distance - 1, velocity)
        return (np.where(self.flat, flat, 0) + np.where(self.kind["two_sides"], second, 0)
                + np.where(self.round, ring, 0))

    def foreign(self, z, velocity, turned, t):
        """Force of a foreign cause per modal mass, at the place where it acts."""
        p, stiff = self.p, self.p["angular"][0] ** 2
        size, n = p["strength"], self.normal
        coupling = stiff * size * ((turned**2).real * n + 0.2 * (turned**3).imag * n * 1j)
        # The crack opens and closes while the sag turns past it.
        across = turned * n
        lost = 0.5 * size * stiff * (1 + turned.real) * along(across, z + p["sag"])
        crack = lost * across
        lift = along(n, z) - p["rest"]
        loose = np.where(lift > 0, 0.7 * size * stiff * lift, 0) * n
        film = stiff * size * p["film_size"] * np.exp(1j * p["film_phase"])
        pulse = 40 * stiff * size * np.exp(-0.5 * ((t - self.last_impact) / p["pulse"]) ** 2) * n
        force = np.zeros_like(z)
        for name, value in (("misalignment", coupling), ("cracked_shaft", crack), ("loose_support", loose),
                            ("oil_whirl", film), ("bearing_fault", pulse)):
            force = np.where(self.kind[name], value, force)
        return force

    def rate(self, state, t, phase, speed):
        """Rates of modes (2), casing (1) and their velocities."""
        p = self.p
        q, casing, v, casing_v = state[0:2], state[2], state[3:5], state[5]
        turned = np.exp(1j * phase)
        at_stop, at_cause = p["at_stop"], p["at_cause"]
        z, zv = (at_stop * q).sum(0), (at_stop * v).sum(0)
        contact = self.contact(z - casing, zv - casing_v)
        foreign = self.foreign((at_cause * q).sum(0), (at_cause * v).sum(0), turned, t)
        spring = p["angular"] ** 2 * (q.real * (1 + p["unequal"]) + 1j * q.imag * (1 - p["unequal"]))
        push = at_stop * contact + at_cause * foreign + p["unbalance"] * speed**2 * turned
        acceleration = push - spring - 2 * p["damping"] * p["angular"] * v
        w = p["casing_angular"]
        casing_push = np.where(p["rigid"], 0, -contact / p["casing_mass"] - w**2 * casing
                               - 0.2 * w * casing_v)
        return np.concatenate([v, casing_v[None], acceleration, casing_push[None]])

    def run(self, settling, turns, every):
        """Displacements of the probes' place: every `every`-th step of the last turns, with the shaft's angle."""
        p, count = self.p, len(self.p["cause"])
        step = 1 / p["speed_hz"] / STEPS
        # The quiet whirl, and a kick: a free vibration that has not died away would be a line of its own.
        state = np.zeros((6, count), complex)
        w = 2 * np.pi * p["speed_hz"] * p["speeds"][0]
        state[0:2] = p["unbalance"] * w**2 / (p["angular"] ** 2 - w**2 + 2j * p["damping"] * p["angular"] * w)
        state[3:5] = 1j * w * state[0:2]
        state[3] += p["kick"] * np.exp(2j * np.pi * self.random.random(count))
        phase, away = np.zeros(count), np.zeros(count)
        seen, angles, deepest = [], [], np.zeros(count)
        touched = np.zeros(count)
        next_impact = np.zeros(count)
        forget = 1 / (p["wander_turns"] * STEPS)
        for k in range((settling + turns) * STEPS):
            t = k * step
            away += -forget * away + np.sqrt(2 * forget) * self.random.standard_normal(count)
            first, last = p["speeds"]
            now_hz = p["speed_hz"] * (first + (last - first) * max(0, k / STEPS - settling) / turns)
            speed = 2 * np.pi * now_hz * (1 + p["wander"] * away)
            p["film_phase"] = p["film_phase"] + p["film_order"] * speed * step \
                + p["film_wander"] * np.sqrt(1 / STEPS) * self.random.standard_normal(count)
            due = t >= next_impact
            self.last_impact = np.where(due, next_impact + 3 * p["pulse"], self.last_impact)
            slipping = 1 + 0.01 * self.random.standard_normal(count)
            next_impact = np.where(due, next_impact + slipping / (p["impact_order"] * now_hz), next_impact)
            half = phase + speed * step / 2
            a = self.rate(state, t, phase, speed)
            b = self.rate(state + step / 2 * a, t + step / 2, half, speed)
            c = self.rate(state + step / 2 * b, t + step / 2, half, speed)
            d = self.rate(state + step * c, t + step, phase + speed * step, speed)
            state = state + step / 6 * (a + 2 * b + 2 * c + d)
            phase = phase + speed * step
            if k >= settling * STEPS:
                if k % every == 0:
                    seen.append((p["at_probe"] * state[0:2]).sum(0))
                    angles.append(phase.copy())
                    depth = self.depth((p["at_stop"] * state[0:2]).sum(0) - state[2])
                    deepest = np.maximum(deepest, depth)
                    touched += depth > 0
        return np.array(seen).T, np.array(angles).T, deepest, touched / len(seen)

    def depth(self, z):
        """Penetration of the deepest contact; negative: a gap."""
        p, reach = self.p, along(self.normal, z)
        flat = np.where(self.kind["two_sides"], np.maximum(reach - 1, -reach - p["second_clearance"]), reach - 1)
        ring = np.abs(z - p["offset"] * self.normal) - 1
        return np.where(self.flat, flat, np.where(self.round, ring, -1))
