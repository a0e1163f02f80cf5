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
    "contact_fraction",
    "amplitude_1x_forward_m",
    "amplitude_1x_backward_m",
    "dominant_order",
    "peak_over_clearance",
    "last_contact_revolution",
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
    contact_fraction: float
    amplitude_1x_m: Optional[float]  # forward
    backward_1x_m: Optional[float]
    dominant_order: Optional[float]
    farthest: float  # of the settled motion, in clearances
    last_contact: int  # revolution, counted from 1; 0 without contact

    def subharmonic(self, n=None):
        """Whether it is a 1/n motion, of any order without n."""
        return self.name == "subharmonic" and (n is None or self.order == n)

    def synchronous_circle(self):
        """Whether it is synchronous and one line, as the eye has it: -1X at most a tenth of +1X (axes within 1.22 : 1), and
        nothing else that counts; a motion that is in contact all along may have a little 2X, as a hole with offset has it."""
        if self.name != "synchronous" or not self.amplitude_1x_m or self.backward_1x_m is None:
            return False
        one_line = self.orbit != "complex" or (self.contact_fraction > 0.999 and self.dominant_order == 1)
        return one_line and self.backward_1x_m <= 0.1 * self.amplitude_1x_m

    def synchronous_oval(self):
        """Whether it is synchronous, an ellipse and no circle; or a comb whose -1X turns by less than a tenth of a turn per
        revolution against its +1X, so that it is synchronous to the eye."""
        if self.name == "synchronous":
            return self.orbit in ("circle", "oval") and not self.synchronous_circle()
        return self.oval() and abs(self.comb_spacing - 2) < 0.2

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
        contact_fraction=csv_table.number(row, "contact_fraction") or 0.0,
        amplitude_1x_m=csv_table.number(row, "amplitude_1x_forward_m"),
        backward_1x_m=csv_table.number(row, "amplitude_1x_backward_m"),
        dominant_order=csv_table.number(row, "dominant_order"),
        farthest=csv_table.number(row, "peak_over_clearance") or 0.0,
        last_contact=int(csv_table.number(row, "last_contact_revolution") or 0),
    )
