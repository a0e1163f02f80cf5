"""The lines above a domain map: heading, rotor, stops, casing and kick of its configuration, in gnuplot's notation."""

import re

from rubplot import captions, configuration


def people_number(value):
    """Four digits, and 2e+06 as 2×10^6."""
    return re.sub(r"e\+?(-?)0*([0-9]+)", r"×10^{\1\2}", "%.4g" % value)


def plain(text):
    """A text that gnuplot shows as it is, where it would read marks for raised letters and the like."""
    return re.sub(r"([\\{}^_@&~])", r"\\\1", text)


def text(title, config, identified_hz=None, varied=()):
    """Three lines, and one more where the configuration names an author or has a note; `identified_hz` is the natural
    frequency of a rotor kit, whose configuration has none. Of the numbers that the picture varies none is said: the
    configuration has one of their values, or none. These are the axes of the sweep, and the keys `varied`."""
    shown = {key: value for key, value in config.items() if key not in {*varied, *swept_keys(config)}}
    lines = [_line(_rotor(shown, identified_hz), _stop(shown)), _line(_casings(shown), _kick(shown, config))]
    own = captions.title(config)
    title = f"{plain(own)}: {title}" if own else title
    text = f"{{/:Bold {title}}}" + "".join(f"\n{{/*0.75 {line}}}" for line in lines if line)
    byline = captions.byline(config)
    return text + (f"\n{{/*0.6 {plain(byline)}}}" if byline else "")


def swept_keys(config):
    """The keys of the configuration that axes of the sweep and scans of a threshold go over."""
    found = set()
    for path in ("sweep.x", "sweep.y", "sweep.z", "study"):
        text = config.get(f"{path}.key") or config.get(f"{path}.keys", "").strip("[]")
        found.update(key.strip() for key in text.split(",") if key.strip())
    return found


def _line(*parts):
    return "; ".join(part for part in parts if part)


def _values(config, *parts, factor=1.0):
    """The texts of those parts (path, before, after) whose number is known, parted by commas."""
    return ", ".join(f"{before}{_value(config, path, factor)}{after}" for path, before, after in parts if path in config)


def _value(config, path, factor=1.0):
    return people_number(configuration.number(config[path]) * factor)


def _rotor(config, identified_hz):
    if config.get("rotor.kind") in ("rotor_kit", "matrices") or "rotor.shaft.0.length_m" in config:
        return "rotor kit" if identified_hz is None else "rotor kit, identified %.4g Hz" % identified_hz
    known = _values(config, ("rotor.mass_kg", "", " kg"), ("rotor.natural_frequency_hz", "", " Hz"),
                    ("rotor.damping_ratio", "ζ = ", ""))
    return f"rotor {known}" if known else ""


def _stop(config):
    """The first stop."""
    known = [
        _values(config, ("stops.0.clearance_m", "clearance ", " mm"), factor=1e3),
        _values(config, ("stops.0.stiffness_n_per_m", "K = ", " N/m"),
                ("stops.0.hertz.design_force_n", "Hertz line contact at ", " N"), ("stops.0.restitution", "nominal e = ", "")),
        _offset(config),
        _values(config, ("stops.0.restitution_delivered", "delivered e = ", "")),
    ]
    return ", ".join(part for part in known if part)


def _offset(config):
    offset = configuration.numbers(config.get("stops.0.offset_m", "[0, 0]"))
    return "" if offset == [0, 0] else "offset [%s] mm" % ", ".join("%.4g" % (1e3 * part) for part in offset)


def _casing(config, stop):
    path = f"stops.{stop}.casing."
    known = _values(config, (path + "mass_kg", "", " kg"), (path + "stiffness_n_per_m", "on ", " N/m"),
                    (path + "damping_ratio", "ζ = ", "")).replace(" kg, on", " kg on")
    return known or "rigid"


def _casings(config):
    """Value of the first stop, and those of all where they differ."""
    casings = [_casing(config, stop) for stop in range(configuration.stop_count(config))]
    different = len(set(casings)) > 1
    return "casing " + ", and ".join(casings if different else casings[:1])


def _kick(config, all_of_it):
    if "kick.force_n" not in all_of_it:
        return "no kick"
    known = [_values(config, ("kick.force_n", "", " N")), _values(config, ("kick.duration_s", "for ", " ms"), factor=1e3)]
    return "kick " + " ".join(part for part in known if part)
