"""The plane that a map is drawn over, with the units and scales in which its axes were written."""

import os
from dataclasses import dataclass
from typing import Dict, Optional

from rubplot import configuration, shown_units, swept_axes
from rubplot.failure import require_readable


@dataclass(frozen=True)
class Plane:
    """The plane of the map in `map_file`: its columns `across` and `up`; `natural_hz` is the frequency over which speeds are drawn,
    None where they are drawn in the unit of the configuration or are not drawn at all."""

    map_file: str
    config: Dict[str, str]
    across: str
    up: str
    natural_hz: Optional[float]

    def axes(self, largest_up):
        """How both axes are shown; `largest_up` as shown_units.axis takes it."""
        across = shown_units.axis(self.config, self.across)
        if self.natural_hz is not None:
            across = shown_units.Axis("shaft speed / natural frequency", 1.0, across.logarithmic)
        return across, shown_units.axis(self.config, self.up, largest_up)


def read_plane(source, identified_hz=None):
    """The plane of a map.csv, or of the one in a directory, which needs its config.yaml beside it; `identified_hz` is the natural
    frequency of a rotor whose configuration has none."""
    map_file = os.path.join(source, "map.csv") if os.path.isdir(source) else source
    config_file = os.path.join(os.path.dirname(map_file), "config.yaml")
    require_readable(map_file, config_file)
    config = configuration.read_configuration(config_file)
    across, up = swept_axes.plane(config)
    natural_hz = identified_hz
    if "rotor.natural_frequency_hz" in config:
        natural_hz = configuration.number(config["rotor.natural_frequency_hz"])
    if across != "speed_hz" or shown_units.in_rpm(config) or shown_units.asks_for_speed():
        natural_hz = None
    return Plane(map_file, config, across, up, natural_hz)


def label(axis):
    """The label of an axis in gnuplot's notation, where keys of the configuration have their own names."""
    return axis.label.replace("_", r"\_")


def logarithmic(axes, *values):
    """Which axes are drawn logarithmically: a scale that was asked for, of values above zero."""
    return tuple(axis.logarithmic and min(of_axis) > 0 for axis, of_axis in zip(axes, values))


def scale_words(scales):
    """The axes that are logarithmic, as templates read them."""
    return " ".join(word for word, on in zip(("logx", "logy"), scales) if on)
