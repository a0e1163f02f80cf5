#!/usr/bin/env python3
"""Writes recordings of rubs and of foreign causes that a simulator of its own made (independent_rotor.py).

Usage: independent_recordings.py DIRECTORY COUNT SEED [--misaligned] [--run-up]

Writes COUNT recordings of rubs and COUNT of others (fewer from machines that hardly rub), as NNNN.csv with its
instrument NNNN.yaml; truth.csv says what each is; machine_K.yaml describes the rotor by its first mode alone, with
the errors of a fit. Four machines run at one speed each, a fifth at half its critical speed, so that the motions that
rubdiagnose simulates serve many recordings. A rub has 3 % or more of its energy off +-1X and goes less deep than half
its clearance.
--misaligned: the rubbing rotors are misaligned, too, so that two causes act at once.
--run-up: the speed changes from 0.8 to 1.25 times that of the machine, or back, in 360 turns; a rub lasts: it has 3 %
off +-1X in four parts of twelve turns in a row, and touches for 2 % of the time.
Needs NumPy. The same arguments give the same bytes on one computer.
"""

import itertools
import math
import pathlib
import sys

import numpy as np

from independent_rotor import FOREIGN, RUBS, STEPS, Rotors

MACHINES, RECORDED, SETTLING, EVERY = 5, 40, 160, 8
RUNS_A_RUB = 9  # runs of a rub beside one of another cause: nine in ten do not touch, or rub synchronously
MOST_ROUNDS = 10  # for each recording that is asked for: machines that never rub end, too
BATCH = 400
SLOWEST, FASTEST, RUN_UP, RUN_UP_SETTLING, PARTS, LASTING = 0.8, 1.25, 360, 120, 30, 4  # of a run-up


def uniform(random, low, high, count):
    return low + (high - low) * random.random(count)


def logarithmic(random, low, high, count):
    return low * (high / low) ** random.random(count)


def draw_machines(random):
    """Frequency and damping of both modes, mass, place of stop and probe, and the speed of each machine."""
    count = MACHINES
    machines = {
        "frequency_hz": uniform(random, 20, 50, count),
        "ratio": uniform(random, 2.6, 5.5, count),
        "damping": np.array([logarithmic(random, 0.01, 0.04, count) for _ in range(2)]),
        "mass_kg": logarithmic(random, 0.5, 10, count),
        "unequal": uniform(random, 0, 0.01, count),
        "second_at_stop": uniform(random, -0.5, 0.5, count),
        "second_at_probe": uniform(random, -0.5, 0.5, count),
        "second_at_cause": uniform(random, -0.5, 0.5, count),
        "speed_ratio": np.concatenate([np.linspace(1.4, 3.6, count - 1), [0.5]]),
    }
    for k in range(count):  # a speed beside the second mode
        if abs(machines["speed_ratio"][k] / machines["ratio"][k] - 1) < 0.12:
            machines["ratio"][k] *= 1.3
    return machines


def draw(random, machines, machine, cause, misaligned, run_up=False):
    """Numbers of one run for each entry of `machine` and `cause`; `misaligned`: rubs have this cause beside them;
    `run_up`: the speed runs up or down."""
    n = len(cause)
    of = {key: value[..., machine] for key, value in machines.items()}
    first = 2 * np.pi * of["frequency_hz"]
    speed_hz = of["frequency_hz"] * of["speed_ratio"]
    p = {"cause": np.array(cause), "speed_hz": speed_hz, "damping": of["damping"], "unequal": of["unequal"],
         "angular": np.array([first, first * of["ratio"]])}
    one = np.ones(n)
    for place in ("stop", "probe", "cause"):
        p["at_" + place] = np.array([one, of["second_at_" + place]])
    p["misaligned"] = (p["cause"] == "misalignment") | (misaligned & np.isin(p["cause"], RUBS))
    p["angle"] = uniform(random, -np.pi, np.pi, n)
    p["second_clearance"] = logarithmic(random, 0.7, 1.43, n)
    p["offset"] = np.where(p["cause"] == "annular_offset", uniform(random, 0.15, 0.9, n), 0)
    p["exponent"] = uniform(random, 1, 1.5, n)
    p["hardness"] = first**2 * logarithmic(random, 10, 300, n) / 0.05 ** (p["exponent"] - 1)
    p["loss"] = uniform(random, 0.05, 0.8, n) / first
    p["friction"] = uniform(random, 0.02, 0.3, n)
    p["clearance_m"] = logarithmic(random, 1e-4, 5e-4, n)
    p["rim_speed"] = 0.02 * 2 * np.pi * speed_hz / p["clearance_m"]
    p["rigid"] = random.random(n) < 0.5
    p["casing_mass"] = logarithmic(random, 0.2, 2, n)
    p["casing_angular"] = 2 * np.pi * logarithmic(random, 100, 1000, n)
    p["kick"] = first * logarithmic(random, 0.3, 10, n) * (random.random(n) < 0.7) \
        * np.isin(p["cause"], RUBS)
    p["wander"] = logarithmic(random, 1e-4, 3e-3, n)
    p["wander_turns"] = uniform(random, 3, 20, n)
    p["strength"] = logarithmic(random, 0.1, 0.8, n)
    p["strength"] = np.where(p["cause"] == "cracked_shaft", uniform(random, 0.05, 0.3, n), p["strength"])
    p["rest"] = uniform(random, 0, 0.4, n)
    p["sag"] = -1j * 9.81 / first**2 / p["clearance_m"]
    p["film_order"] = uniform(random, 0.42, 0.48, n)
    p["film_phase"], p["film_size"] = np.zeros(n), 3 * np.ones(n)
    p["film_wander"] = logarithmic(random, 0.003, 0.03, n)
    p["impact_order"] = uniform(random, 3.02, 3.95, n)
    p["pulse"] = 0.02 / speed_hz
    # Unbalance of both modes, for a whirl of this size at the place of the stop.
    wanted = logarithmic(random, 0.2, 1.5, n)
    second = uniform(random, 0, 1, n) * np.exp(2j * np.pi * random.random(n))
    unbalance = np.array([one, second], complex)
    w = 2 * np.pi * speed_hz
    gain = w**2 / (p["angular"] ** 2 - w**2 + 2j * p["damping"] * p["angular"] * w)
    p["unbalance"] = unbalance * wanted / np.abs((p["at_stop"] * unbalance * gain).sum(0))
    p["speeds"] = np.ones((2, n))
    if run_up:
        down = random.random(n) < 0.5
        p["speeds"] = np.where(down, [[FASTEST], [SLOWEST]], [[SLOWEST], [FASTEST]])
    return p


def off_1x(z, angle, growing=False):
    """Share of the energy about the mean that lines at +1X and -1X leave; `growing`: these may grow or decay."""
    turned = np.exp(1j * angle)
    grown = (angle - angle.mean()) * turned
    basis = np.array([np.ones_like(angle), turned, turned.conj()] + [grown, grown.conj()] * growing).T
    left = z - basis @ np.linalg.lstsq(basis, z, rcond=None)[0]
    return float((np.abs(left) ** 2).sum() / max((np.abs(z - z.mean()) ** 2).sum(), 1e-300))


def disturbed(cause, z, angle, t, random):
    """Readings (x, y) with what the measurement adds."""
    size = np.sqrt((np.abs(z - z.mean()) ** 2).mean())
    x, y = z.real.copy(), z.imag.copy()
    if cause == "run_out":
        for order in range(1, 11):
            a = size * random.uniform(0.1, 1) / math.sqrt(order) * np.exp(2j * np.pi * random.random())
            x += (a * np.exp(1j * order * angle)).real
            y += (a * np.exp(1j * order * (angle - np.pi / 2))).real
    if cause == "mains_hum":
        for part in (x, y):
            part += size * random.uniform(0.1, 1) * np.cos(2 * np.pi * 50.01 * t + 2 * np.pi * random.random())
    if cause == "clipped_probe":
        x = np.minimum(x, np.quantile(x, random.uniform(0.75, 0.95)))
    noise = size * random.uniform(0.001, 0.01)
    out = []
    for part in (x, y):
        read = part * (1 + 0.01 * random.standard_normal()) + noise * random.standard_normal(len(part))
        unit = 2 * random.uniform(1.5, 4) * np.abs(read).max() / 2 ** random.integers(12, 17)
        out.append(np.round(read / unit) * unit)
    return out


def lasting_off_1x(z, angle):
    """The largest share that LASTING parts of a run-up in a row have or exceed."""
    shares = [off_1x(*part, growing=True) for part in zip(np.array_split(z, PARTS), np.array_split(angle, PARTS))]
    return max(min(shares[k:k + LASTING]) for k in range(PARTS - LASTING + 1))


def write(stem, cause, z, angle, sampling_hz, probes, random):
    """Writes table and description of one recording."""
    t = np.arange(len(z)) / sampling_hz
    x, y = disturbed(cause, z, angle, t, random)
    turn = angle / (2 * np.pi) - np.round(angle / (2 * np.pi))
    key = -1 - 8 * np.clip(4 - np.abs(turn) / 0.01, 0, 1)
    columns = [t, 1e6 * x] + ([1e6 * y] if probes == 2 else []) + [key]
    with open(f"{stem}.csv", "w", encoding="ascii") as out:
        out.write("t (s),X (um),Y (um),KP (V)\n" if probes == 2 else "t (s),X (um),KP (V)\n")
        for row in zip(*columns):
            out.write(",".join(f"{value:.7g}" for value in row) + "\n")
    with open(f"{stem}.yaml", "w", encoding="ascii") as out:
        out.write("time: t\nkeyphasor: {column: KP, mark: dark}\nprobes:\n  - {column: X, angle_deg: 0}\n")
        if probes == 2:
            out.write("  - {column: Y, angle_deg: 90}\n")


def write_machine(path, machines, k, random):
    """Writes the first mode alone, with a fit's errors."""
    frequency = machines["frequency_hz"][k] * (1 + 0.003 * random.standard_normal())
    damping = machines["damping"][0][k] * (1 + 0.07 * random.standard_normal())
    path.write_text(
        f"rotor: {{kind: jeffcott, mass_kg: {machines['mass_kg'][k]:.6g}, natural_frequency_hz: {frequency:.6g}, "
        f"damping_ratio: {damping:.4g}}}\n"
        "stops:\n  - {kind: one_side, angle_deg: 90, clearance_m: 3.0e-4, stiffness_n_per_m: 2.0e6, "
        "restitution: 0.7, contact_radius_m: 0.02}\nkick: {force_n: 100, duration_s: 0.005}\n"
        f"sweep: {{speed_hz: {{values: [{machines['frequency_hz'][k] * machines['speed_ratio'][k]:.6g}]}}, "
        "whirl_ratio: {values: [0.3]}}\noutput: {directory: out}\n", encoding="ascii")


def all_runs(rounds):
    """Cause and machine of every run, ten a round; a cracked shaft and some rotors without rub run at half their
    critical speed. Rubs and others take turns, so that the first recordings stand for all.
    """
    for k in range(rounds):
        for i in range(RUNS_A_RUB * k, RUNS_A_RUB * (k + 1)):
            yield RUBS[i % 4], i // 4 % (MACHINES - 1)
        cause = "no_rub" if k % 2 == 0 else FOREIGN[k // 2 % len(FOREIGN)]
        slow = cause == "cracked_shaft" or k % 16 == 0
        yield cause, MACHINES - 1 if slow else k // 3 % (MACHINES - 1)


def main(directory, count, seed, misaligned, run_up):
    directory.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(seed)
    machines = draw_machines(random)
    for k in range(MACHINES):
        write_machine(directory / f"machine_{k}.yaml", machines, k, random)
    runs, kept = all_runs(MOST_ROUNDS * count), dict.fromkeys(("rub", "other"), 0)
    settling, recorded, every = (RUN_UP_SETTLING, RUN_UP, 2 * EVERY) if run_up else (SETTLING, RECORDED, EVERY)
    with open(directory / "truth.csv", "w", encoding="ascii") as truth:
        truth.write("recording,cause,machine,probes,off_1x,deepest,contact_share,wander\n")
        while min(kept.values()) < count and (part := list(itertools.islice(runs, BATCH))):
            causes, machine = [run[0] for run in part], np.array([run[1] for run in part])
            p = draw(random, machines, machine, causes, misaligned, run_up)
            seen, angles, deepest, touched = Rotors(p, random).run(settling, recorded, every)
            for i, cause in enumerate(causes):
                z, kind = seen[i] * p["clearance_m"][i], "rub" if cause in RUBS else "other"
                if not np.isfinite(z).all() or kept[kind] >= count:
                    continue
                off = (lasting_off_1x if run_up else off_1x)(z, angles[i])
                least_touched = 0.02 if run_up else 0
                if kind == "rub" and not (0 < deepest[i] < 0.5 and off >= 0.03 and touched[i] >= least_touched):
                    continue
                number, probes = sum(kept.values()), 1 if random.random() < 0.25 else 2
                kept[kind] += 1
                write(directory / f"{number:04}", cause, z, angles[i], p["speed_hz"][i] * STEPS / every, probes, random)
                truth.write(f"{number:04},{cause},{machine[i]},{probes},{off:.4g},{deepest[i]:.4g},"
                            f"{touched[i]:.4g},{p['wander'][i]:.3g}\n")
            truth.flush()
    print(f"{kept['rub']} rubs, {kept['other']} others in {directory}")


if __name__ == "__main__":
    if len(sys.argv) < 4 or not set(sys.argv[4:]) <= {"--misaligned", "--run-up"}:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]), "--misaligned" in sys.argv,
         "--run-up" in sys.argv)
