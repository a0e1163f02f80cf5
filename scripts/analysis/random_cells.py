"""Configurations of one random cell each: what makes a cell dear is drawn on purpose, as stiff walls, slow turns,
friction that holds, light casings, and every solver."""

import json
import math
import random

STEPPERS = ("dopri5", "cash_karp54", "rkf78", "bulirsch_stoer", "rosenbrock4")


def log_uniform(draw, low, high):
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def random_friction(draw):
    kind = draw.random()
    if kind < 0.25:
        return None
    if kind < 0.65:
        return {"coefficient": draw.uniform(0.02, 0.8)}
    if kind < 0.9:
        return {"stribeck": [0, 0, 0, draw.uniform(0.02, 0.5), log_uniform(draw, 10, 3000), 0]}
    return {"one_way": draw.uniform(0.02, 0.3)}


def random_stop(draw, clearance_m, shaft_n_per_m, mass_kg, annular):
    stop = {"kind": "annular" if annular else "one_side", "clearance_m": clearance_m,
            "stiffness_n_per_m": shaft_n_per_m * log_uniform(draw, 3, 1e5),
            "restitution": draw.choice((1, draw.uniform(0.3, 0.95))),
            "contact_radius_m": draw.choice((0, max(2 * clearance_m, log_uniform(draw, 1e-4, 0.05))))}
    if not annular:
        stop["angle_deg"] = draw.choice((-90, 0, 90, draw.uniform(0, 360)))
    friction = random_friction(draw)
    if friction:
        stop["friction"] = friction
    if draw.random() < 0.4:
        stop["casing"] = {"mass_kg": mass_kg * log_uniform(draw, 3e-3, 1),
                          "stiffness_n_per_m": shaft_n_per_m * log_uniform(draw, 0.3, 100),
                          "damping_ratio": draw.choice((0, log_uniform(draw, 0.005, 0.5)))}
    return stop


def random_cell(seed, number):
    """Cell `number` of those drawn by `seed`, as the tree of a configuration."""
    draw = random.Random("%d/%d" % (seed, number))
    mass_kg, natural_hz = log_uniform(draw, 0.1, 5), draw.uniform(10, 45)
    clearance_m = log_uniform(draw, 5e-5, 2e-3)
    shaft_n_per_m = mass_kg * (2 * math.pi * natural_hz) ** 2
    annular = draw.random() < 0.2
    count = 1 if annular else draw.randint(1, 3)
    speed_hz = natural_hz * (draw.uniform(0.5, 5) if draw.random() < 0.5 else log_uniform(draw, 3e-3, 0.5))
    duration_s = log_uniform(draw, 0.03, 0.4) / natural_hz
    cell = {
        "rotor": {"kind": "jeffcott", "mass_kg": mass_kg, "natural_frequency_hz": natural_hz,
                  "damping_ratio": log_uniform(draw, 0.002, 0.1)},
        "stops": [random_stop(draw, clearance_m, shaft_n_per_m, mass_kg, annular) for _ in range(count)],
        "kick": {"duration_s": duration_s,
                 "force_n": log_uniform(draw, 1, 6) * clearance_m * mass_kg * math.pi ** 2 * natural_hz
                 / duration_s},
        "sweep": {"speed_hz": speed_hz, "eccentricity_m": clearance_m * log_uniform(draw, 0.01, 0.5)},
        "solver": {"method": "auto"},
    }
    if draw.random() < 0.4:
        cell["gravity_m_per_s2"] = draw.choice((9.81, shaft_n_per_m * clearance_m * draw.uniform(1, 3) / mass_kg))
    if draw.random() < 0.2:
        cell["solver"] = {"method": "adaptive", "stepper": draw.choice(STEPPERS),
                          "relative_tolerance": draw.choice((1e-6, 1e-8, 1e-10, 1e-12))}
    return cell


def put_on_kit(draw, cell):
    """A shaft with one disc on two supports in the place of the Jeffcott rotor, of about its mass and frequency."""
    length_m = draw.uniform(0.3, 0.6)
    support = {"stiffness_x_n_per_m": log_uniform(draw, 2e4, 1e6), "damping_x_ns_per_m": log_uniform(draw, 1, 200)}
    support.update(stiffness_y_n_per_m=support["stiffness_x_n_per_m"] * draw.choice((1, draw.uniform(0.5, 1))),
                   damping_y_ns_per_m=support["damping_x_ns_per_m"])
    mass_kg = min(1.5, max(0.3, cell["rotor"]["mass_kg"]))
    disc_m = length_m * draw.uniform(0.3, 0.7)
    cell["rotor"] = {
        "kind": "rotor_kit",
        "shaft": [{"length_m": length_m, "outer_diameter_m": draw.uniform(0.008, 0.014), "youngs_modulus_pa": 2.06e11,
                   "shear_modulus_pa": 7.92e10, "density_kg_per_m3": 7850}],
        "discs": [{"position_m": disc_m, "mass_kg": mass_kg, "polar_inertia_kg_m2": 7e-4 * mass_kg,
                   "diametral_inertia_kg_m2": 4e-4 * mass_kg}],
        "supports": [dict(support, position_m=0.05 * length_m), dict(support, position_m=0.95 * length_m)],
        "sensors": [{"position_m": length_m * draw.uniform(0.3, 0.7), "angle_deg": angle} for angle in (0, 90)],
        "damping_ratio": log_uniform(draw, 0.005, 0.05), "modes_up_to_hz": 1500}
    for stop in cell["stops"]:
        stop["position_m"] = disc_m + length_m * draw.uniform(-0.1, 0.2)
    cell["kick"]["position_m"] = disc_m


def with_kits(seed, number, share=0.05):
    """Cell `number` of those drawn by `seed`, a share of which are put on kits."""
    cell, draw = random_cell(seed, number), random.Random("%d/%d/kit" % (seed, number))
    if draw.random() < share:
        put_on_kit(draw, cell)
    return cell


def text_of(cell):
    """A configuration file: JSON is YAML."""
    return json.dumps(dict(cell, output={"directory": "map"}), indent=1)
