"""One finding of the paper: what is said, what is counted, and what a machine's maps show of it."""

from dataclasses import dataclass
from typing import Callable, Tuple

HOLDS, PARTLY, NOT_REPRODUCED, NO_MAP = "holds", "partly", "not reproduced", "no map"

# A statement without exception about a domain holds where nine cells in ten agree: its rims are about a cell wide, and
# take up a tenth of a domain of the size found here. It is partly so where it is more often so than not.
MOST, HALF = 0.9, 0.5
SHARES = "holds above 90 % (the rims of a domain are a tenth of it), partly above 50 % (more often so than not)"


@dataclass(frozen=True)
class Outcome:
    """The number that decides, the same without any filter, and the verdict."""

    measured: str
    unfiltered: str
    verdict: str


@dataclass(frozen=True)
class Finding:
    """`roles` are the maps that `measure` needs; it is called with the machine."""

    title: str
    paper: str
    counted: str
    cells: str
    threshold: str
    roles: Tuple[str, ...]
    measure: Callable[[object], Outcome]

    def outcome(self, machine):
        if any(role not in machine.maps for role in self.roles):
            return Outcome("no map", "no map", NO_MAP)
        return self.measure(machine)


def with_and_without_filter(unfiltered, filtered):
    """What holds without any filter holds; what holds of the filtered cells alone holds partly."""
    return HOLDS if unfiltered else PARTLY if filtered else NOT_REPRODUCED


def of_share(share):
    """The verdict on a share of cells of which the paper says what it says without exception."""
    return HOLDS if share > MOST else PARTLY if share > HALF else NOT_REPRODUCED


def share(part, whole):
    """part / whole, 0 where there is nothing."""
    return part / whole if whole else 0.0


def percent(part, whole):
    return "%.0f %%" % (100 * share(part, whole))


def figure(value, digits=2):
    """A number as the table has it; a dash where the map shows none."""
    return "-" if value is None else f"{value:.{digits}f}"
