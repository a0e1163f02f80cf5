"""One finding of the paper: what is said, what is counted, and what a machine's maps show of it."""

from dataclasses import dataclass
from typing import Callable, Tuple

HOLDS, PARTLY, NOT_REPRODUCED, NO_MAP = "holds", "partly", "not reproduced", "no map"

# A statement without exception about a domain that was read off a picture holds where nine tenths agree: its rims are about
# a cell wide, and take up a tenth of a domain of the size found here. It is partly so where it is more often so than not.
MOST, HALF = 0.9, 0.5
SHARES = "holds from 90 % on, partly from 50 %"
# A domain is seen where it takes up more of the map than this: eleven of 1650 cells.
SEEN = 1 / 150


@dataclass(frozen=True)
class Outcome:
    """The number that decides, and the verdict."""

    measured: str
    verdict: str


@dataclass(frozen=True)
class Finding:
    """`roles` are the maps that `measure` needs; it is called with the machine. `reason` says why the measure is neither
    stricter nor more lenient than the sentence."""

    title: str
    paper: str
    counted: str
    threshold: str
    reason: str
    roles: Tuple[str, ...]
    measure: Callable[[object], Outcome]

    def outcome(self, machine):
        if any(role not in machine.maps for role in self.roles):
            return Outcome("no map", NO_MAP)
        return self.measure(machine)


def of_both(first, second):
    """Both of two conditions: holds where both do, partly where one does."""
    return HOLDS if first and second else PARTLY if first or second else NOT_REPRODUCED


def of_share(share, holds=MOST, partly=HALF):
    """The verdict on a share; None, where there is nothing to see, is not reproduced."""
    if share is None:
        return NOT_REPRODUCED
    return HOLDS if share >= holds else PARTLY if share >= partly else NOT_REPRODUCED


def share(part, whole):
    """part / whole, 0 where there is nothing."""
    return part / whole if whole else 0.0


def percent(value):
    """A share as the table has it; a dash where there is none."""
    return "-" if value is None else "%.0f %%" % (100 * value)


def figure(value, digits=2):
    """A number as the table has it; a dash where the map shows none."""
    return "-" if value is None else f"{value:.{digits}f}"
