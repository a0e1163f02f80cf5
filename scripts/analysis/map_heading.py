"""What stands above a domain map: heading, rotor, stops, casing and kick of its configuration, in gnuplot's notation."""

import re

import configuration


def people_number(value):
    """Four digits, and 2e+06 as 2×10^6."""
    return re.sub(r"e\+?(-?)0*([0-9]+)", r"×10^{\1\2}", "%.4g" % value)


def heading(title, config, identified_hz=None):
    """Three lines; `identified_hz` is the natural frequency of a rotor kit, whose configuration has none."""
    lines = (
        f"{_rotor(config, identified_hz)}; {_stop(config)}",
        f"{_casings(config)}; {_kick(config)}",
    )
    return f"{{/:Bold {title}}}" + "".join(f"\n{{/*0.75 {line}}}" for line in lines)


def _value(config, path, factor=1.0):
    return people_number(configuration.number(config[path]) * factor)


def _rotor(config, identified_hz):
    if "rotor.natural_frequency_hz" not in config:
        return "rotor kit" if identified_hz is None else "rotor kit, identified %.4g Hz" % identified_hz
    mass, frequency, damping = (
        _value(config, f"rotor.{key}") for key in ("mass_kg", "natural_frequency_hz", "damping_ratio")
    )
    return f"rotor {mass} kg, {frequency} Hz, ζ = {damping}"


def _stop(config):
    """The first stop."""
    text = f"clearance {_value(config, 'stops.0.clearance_m', 1e3)} mm"
    for path, before, after in (
        ("stops.0.stiffness_n_per_m", "K = ", " N/m"),
        ("stops.0.hertz.design_force_n", "Hertz line contact at ", " N"),
        ("stops.0.restitution", "nominal e = ", ""),
    ):
        if path in config:
            text += f", {before}{_value(config, path)}{after}"
    offset = config.get("stops.0.offset_m", "[0, 0]")
    if offset != "[0, 0]":
        text += f", offset {offset} m"
    if "stops.0.restitution_delivered" in config:
        text += f", delivered e = {_value(config, 'stops.0.restitution_delivered')}"
    return text


def _casing(config, stop):
    path = f"stops.{stop}.casing."
    if path + "mass_kg" not in config:
        return "rigid"
    mass, stiffness, damping = (
        _value(config, path + key) for key in ("mass_kg", "stiffness_n_per_m", "damping_ratio")
    )
    return f"{mass} kg on {stiffness} N/m, ζ = {damping}"


def _casings(config):
    """That of the first stop, and those of all where they differ."""
    casings = [_casing(config, stop) for stop in range(configuration.stop_count(config))]
    different = len(set(casings)) > 1
    return "casing " + ", and ".join(casings if different else casings[:1])


def _kick(config):
    if "kick.force_n" not in config:
        return "no kick"
    return f"kick {_value(config, 'kick.force_n')} N for {_value(config, 'kick.duration_s', 1e3)} ms"
