"""The axes of a map that have several values, by its config.yaml, as columns of map.csv."""

from rubplot import configuration


# Keys of speed and unbalance, and the column of map.csv that holds what they say in SI units.
SPEEDS = {"speed_hz": "speed_hz", "speed_rpm": "speed_hz"}
UNBALANCES = {
    "whirl_ratio": "whirl_ratio",
    "eccentricity_m": "eccentricity_m",
    "unbalance_g_mm": "eccentricity_m",
    "balance_grade_mm_per_s": "eccentricity_m",
}


def swept_axes(config):
    """Columns of the axes with more than one value, fastest first."""
    return [name for name, path in _paths(config) if len(configuration.axis(config, path)) > 1]


def plane(config):
    """The columns that a picture of the map is drawn over, across and up: speed and unbalance, or the two axes with
    several values where keys are swept."""
    unbalance = "whirl_ratio" if configuration.axis(config, "sweep.whirl_ratio") else "eccentricity_m"
    swept = swept_axes(config)
    if len(swept) > 2:
        raise configuration.ConfigurationError(f"{', '.join(swept)} have several values, a picture has room for two")
    if not configuration.axis(config, "sweep.x") or not swept:
        return "speed_hz", unbalance
    if len(swept) == 2:
        return swept[0], swept[1]
    return swept[0], unbalance if swept[0] == "speed_hz" else "speed_hz"


def _paths(config):
    """Every column that may be an axis, and the key of the axis."""
    columns = [(column, f"sweep.{name}") for name, column in (SPEEDS | UNBALANCES).items()]
    for axis in "xyz":
        keys = config.get(f"sweep.{axis}.key") or config.get(f"sweep.{axis}.keys", "").strip("[]").split(",")[0]
        columns.append((keys, f"sweep.{axis}"))
    return columns
