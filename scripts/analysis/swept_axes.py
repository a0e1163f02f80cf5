"""The axes of a map that have several values, by its config.yaml, as columns of map.csv."""

import configuration


def swept_axes(config):
    """Columns of the axes with more than one value, fastest first."""
    columns = [("speed_hz", "sweep.speed_hz")]
    columns += [(name, f"sweep.{name}") for name in ("whirl_ratio", "eccentricity_m")]
    for axis in "xyz":
        keys = config.get(f"sweep.{axis}.key") or config.get(f"sweep.{axis}.keys", "").strip("[]").split(",")[0]
        columns.append((keys, f"sweep.{axis}"))
    return [name for name, path in columns if len(_values(config, path)) > 1]


def plane(config):
    """The columns that a picture of the map is drawn over, across and up: speed and unbalance, or the two axes with
    several values where keys are swept."""
    unbalance = "eccentricity_m" if "sweep.eccentricity_m.values" in config else "whirl_ratio"
    swept = swept_axes(config)
    if len(swept) > 2:
        raise configuration.ConfigurationError(f"{', '.join(swept)} have several values, a picture has room for two")
    if "sweep.x.values" not in config or not swept:
        return "speed_hz", unbalance
    if len(swept) == 2:
        return swept[0], swept[1]
    return swept[0], unbalance if swept[0] == "speed_hz" else "speed_hz"


def values(config, column):
    """The values of the axis that is this column, in the order of the configuration."""
    for name in ("speed_hz", "whirl_ratio", "eccentricity_m", "x", "y", "z"):
        first = config.get(f"sweep.{name}.key") or config.get(f"sweep.{name}.keys", name).strip("[]").split(",")[0]
        if first == column:
            return _values(config, f"sweep.{name}")
    raise configuration.ConfigurationError(f"no axis is called {column}")


def _values(config, path):
    text = config.get(f"{path}.values")
    return configuration.numbers(text) if text else []
