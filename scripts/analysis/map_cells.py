"""The cells of a map.csv as the findings count them: speeds in natural frequencies, orders as numbers."""

from dataclasses import dataclass
from typing import Optional

from rubplot import csv_table

COLUMNS = (
    "speed_hz",
    "whirl_ratio",
    "class",
    "order",
    "orbit",
    "comb_spacing",
    "hits_per_revolution",
    "amplitude_1x_forward_m",
    "dominant_order",
)


@dataclass(frozen=True)
class MapCell:
    speed_hz: float
    speed: float  # over the natural frequency
    ratio: float  # whirl ratio
    name: str  # class
    order: Optional[int]
    orbit: str
    comb_spacing: Optional[float]
    hits: float  # per revolution
    amplitude_1x_m: Optional[float]
    dominant_order: Optional[float]

    def subharmonic(self, n=None):
        """Whether it is a 1/n motion, of any order without n."""
        return self.name == "subharmonic" and (n is None or self.order == n)

    def own_domain(self):
        """Whether a 1/n motion hits once in n turns, as those of the 1/n domain do; islands beside it hit more often."""
        return self.subharmonic() and self.hits * self.order < 1.5

    def synchronous_circle(self):
        return self.name == "synchronous" and self.orbit == "circle"

    def oval(self):
        """Whether it is quasi-periodic in space and closed in the rotating frame: its lines are a comb."""
        return self.name == "quasi_periodic" and self.comb_spacing is not None

    def rubs(self):
        return self.name in ("synchronous", "resting_contact", "subharmonic", "quasi_periodic", "chaotic", "unsettled")


def read_map(path, natural_frequency_hz):
    """The cells of a map in the order of the file, without those that have no whirl ratio: where static forces take the
    clearance there is none."""
    rows = csv_table.read_table(path, *COLUMNS)
    return [_cell(row, natural_frequency_hz) for row in rows if row["whirl_ratio"]]


def _cell(row, natural_frequency_hz):
    speed_hz = csv_table.number(row, "speed_hz")
    order = csv_table.number(row, "order")
    return MapCell(
        speed_hz=speed_hz,
        speed=speed_hz / natural_frequency_hz,
        ratio=csv_table.number(row, "whirl_ratio"),
        name=row["class"],
        order=None if order is None else int(order),
        orbit=row["orbit"],
        comb_spacing=csv_table.number(row, "comb_spacing"),
        hits=csv_table.number(row, "hits_per_revolution") or 0.0,
        amplitude_1x_m=csv_table.number(row, "amplitude_1x_forward_m"),
        dominant_order=csv_table.number(row, "dominant_order"),
    )
