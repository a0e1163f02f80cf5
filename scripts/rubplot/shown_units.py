"""The units and scales in which a person wrote the axes of a sweep, so that pictures show the same, and the units that the
command line asks for instead."""

import contextlib
import math
from dataclasses import dataclass
from typing import Optional

from rubplot import configuration

RPM_PER_HZ = 60
# The unit of lengths by the size of the motion in metres, so that the numbers at an axis stay short.
_LENGTHS = ((2e-8, 1e9, "nm"), (2e-5, 1e6, "µm"), (math.inf, 1e3, "mm"))
# Names of --length-unit; a mil is a thousandth of an inch.
LENGTH_UNITS = {"mm": (1e3, "mm"), "um": (1e6, "µm"), "mil": (1 / 25.4e-6, "mil")}
SPEED_UNITS = ("hz", "rpm")

# Keys of a sweep that say the same as a column of map.csv in another unit: column, what stands at the axis.
_WRITTEN = {
    "speed_rpm": ("speed_hz", "shaft speed (rpm)"),
    "unbalance_g_mm": ("eccentricity_m", "unbalance (g mm)"),
    "balance_grade_mm_per_s": ("eccentricity_m", "balance grade (mm/s)"),
}
_LABELS = {
    "speed_hz": "shaft speed (Hz)",
    "whirl_ratio": "whirl ratio (quiet whirl / clearance)",
    "eccentricity_m": "eccentricity (m)",
}


@dataclass(frozen=True)
class Axis:
    label: str
    factor: float = 1.0  # of the unit that is shown, to one in SI
    logarithmic: bool = False


@dataclass(frozen=True)
class Choice:
    """Units that were asked for: one of SPEED_UNITS and of LENGTH_UNITS, None for those of configuration and size."""

    speed: Optional[str] = None
    length: Optional[str] = None
    peak_to_peak: bool = False


_choice = Choice()


@contextlib.contextmanager
def chosen(choice):
    """Everything that is laid out meanwhile is in these units."""
    global _choice
    before, _choice = _choice, choice
    try:
        yield
    finally:
        _choice = before


def axis(config, column, largest=None):
    """How the axis that is this column is shown; `largest` is its largest value in SI units where it is the axis of a
    map, by which the factor of an unbalance is known: how many g mm a metre is, only the programs know of every rotor."""
    if column == "speed_hz" and _choice.speed:
        scales = [config.get(f"sweep.{key}.scale") for key in ("speed_hz", "speed_rpm")]
        if _choice.speed == "rpm":
            return Axis(_WRITTEN["speed_rpm"][1], RPM_PER_HZ, "log" in scales)
        return Axis(_LABELS["speed_hz"], 1.0, "log" in scales)
    for key, (si_column, label) in _WRITTEN.items():
        written = _largest(config, f"sweep.{key}")
        if si_column != column or written is None:
            continue
        factor = RPM_PER_HZ if key == "speed_rpm" else written / largest if largest and written else _factor(config, key)
        if factor is not None:
            return Axis(label, factor, config.get(f"sweep.{key}.scale") == "log")
    return Axis(_LABELS.get(column, column), 1.0, config.get(f"{_path(config, column)}.scale") == "log")


def of_length(largest_m):
    """The number of units in a metre and their name, for lengths up to this one."""
    if _choice.length:
        return LENGTH_UNITS[_choice.length]
    return next((factor, word) for limit, factor, word in _LENGTHS if largest_m < limit)


def of_amplitude(largest_m):
    """The same for amplitudes, half of what a motion spans: peak to peak where that was asked for."""
    factor, word = of_length(2 * largest_m if _choice.peak_to_peak else largest_m)
    return (2 * factor, f"{word} peak to peak") if _choice.peak_to_peak else (factor, word)


def millimetres():
    """Pictures that are in millimetres unless another unit was asked for: the number in a metre and the name."""
    return LENGTH_UNITS[_choice.length or "mm"]


def asks_for_speed():
    """Whether a unit of speeds was asked for."""
    return _choice.speed is not None


def in_rpm(config):
    if _choice.speed:
        return _choice.speed == "rpm"
    return _largest(config, "sweep.speed_rpm") is not None


def speed_text(config, speed_hz):
    """A shaft speed to four digits, in rpm and before that in Hz unless the configuration is in rpm."""
    rpm = f"{float('%.4g' % (RPM_PER_HZ * speed_hz)):.15g} rpm"  # without an exponent
    return rpm if in_rpm(config) else "%.4g Hz (%s)" % (speed_hz, rpm)


def _factor(config, key):
    """The g mm in a metre of eccentricity, known where one disc is all the mass there is."""
    mass_kg = config.get("rotor.mass_kg")
    return 1e6 * configuration.number(mass_kg) if key == "unbalance_g_mm" and mass_kg else None


def _largest(config, path):
    """The largest value of an axis in the unit of its key; None where there is no such axis."""
    if f"{path}.values" in config:
        return max(configuration.numbers(config[f"{path}.values"]), default=None)
    ends = [configuration.number(config[f"{path}.{end}"]) for end in ("from", "to") if f"{path}.{end}" in config]
    return max(ends, default=None)


def _path(config, column):
    for name in "xyz":
        keys = config.get(f"sweep.{name}.key") or config.get(f"sweep.{name}.keys", "").strip("[]").split(",")[0]
        if keys == column:
            return f"sweep.{name}"
    return f"sweep.{column}"
