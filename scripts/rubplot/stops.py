"""The stops of a machine as a picture of its motion shows them."""

import math
from dataclasses import dataclass

from rubplot import configuration

SAME_PLACE = 1e-9
MOST_LETTERS = 32  # of a name in the line below a picture


@dataclass
class Stops:
    """The stops of a configuration in metres, and the columns of trajectory.csv that hold the moving walls. Only what
    stands where the rotor is looked at can be drawn around its orbit; what stands elsewhere along a shaft is drawn in the
    time history, together with the rotor there."""

    walls: list  # (normal x, normal y, clearance) of flat walls around the orbit
    rings: list  # (centre x, centre y, clearance), likewise
    moving: list  # (name of the column, y at rest) of walls that move up and down
    levels: list  # y of walls at rest that a time history reaches
    elsewhere: list  # (name of the gap's column, that of the casing or None, y at rest) of walls at other places
    places: str  # where the rotor is looked at and where stops stand elsewhere, in words; empty where they are one place


def observed_place_m(config):
    """Along the shaft of a rotor kit, where its first sensor is, else its first stop; None where there is no shaft."""
    for path in ("rotor.sensors.0.position_m", "stops.0.position_m"):
        if path in config:
            return configuration.number(config[path])
    return None


def read_stops(config):
    stops = Stops([], [], [], [], [], "")
    observed = observed_place_m(config)
    others = []
    for i in range(configuration.stop_count(config)):
        path = f"stops.{i}."
        place = configuration.number(config[path + "position_m"]) if path + "position_m" in config else observed
        here = place is None or abs(place - observed) < SAME_PLACE
        if not here:
            name = f" ({configuration.text(config[path + 'name'])[:MOST_LETTERS]})" if path + "name" in config else ""
            others.append(f"stop {i}{name} at {1e3 * place:.4g} mm")
        _add_stop(stops, config, i, here)
    if others:
        stops.places = f"seen at {1e3 * observed:.4g} mm, {', '.join(others)}"
    return stops


def _add_stop(stops, config, i, here):
    path = f"stops.{i}."
    clearance_m = configuration.number(config[path + "clearance_m"])
    if config[path + "kind"] == "annular":
        # The casing's centre as seen from the rotor's rest position.
        offset = configuration.numbers(config.get(path + "offset_m", "[0, 0]"))
        if here:
            stops.rings.append((-offset[0], -offset[1], clearance_m))
            stops.levels += [-offset[1] - clearance_m, -offset[1] + clearance_m]
        return
    if config[path + "kind"] != "one_side":
        raise configuration.ConfigurationError(f"{path}kind: {config[path + 'kind']} cannot be drawn")
    angle_deg = configuration.number(config[path + "angle_deg"])
    angle = angle_deg * math.pi / 180
    if here:
        stops.walls.append((math.cos(angle), math.sin(angle), clearance_m))
    upright = abs(math.remainder(angle_deg, 360)) == 90
    if not upright:
        return
    rest_m = math.copysign(clearance_m, math.sin(angle))
    casing = f"casing_{i}_y_m" if path + "casing.mass_kg" in config else None
    stops.levels.append(rest_m)
    if casing:
        stops.moving.append((casing, rest_m))
    if not here:
        stops.elsewhere.append((f"gap_{i}_m", casing, rest_m))
