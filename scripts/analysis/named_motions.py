"""Whether a map shows the motions that the paper names for its figure, and nothing else."""

from domain_measures import Areas
from finding import SHARES, Finding, Outcome, of_share, percent

# The domain of 1/n begins at n natural frequencies, and the maps end at eight.
LARGEST_ORDER = 7


def one_of_n(cell):
    return cell.subharmonic() and cell.order <= LARGEST_ORDER


def synchronous(cell):
    return cell.name == "synchronous"


def quasi_periodic(cell):
    return cell.name == "quasi_periodic"


def nothing_else(title, role, named, words):
    """The finding that nine tenths of the rub are of the motions `named`, a list of predicates that `words` lists."""

    def measure(machine):
        cells = machine.cells(role)
        rub = [cell for cell in cells if cell.rubs()]
        if not rub:
            return Outcome("no rub", of_share(None))
        areas = Areas(cells)
        found = areas.share([cell for cell in rub if any(belongs(cell) for belongs in named)], rub)
        irregular = areas.share([cell for cell in rub if cell.name in ("chaotic", "unsettled")], rub)
        return Outcome(f"{percent(found)} of the rub; {percent(irregular)} is chaotic or unsettled", of_share(found))

    return Finding(
        title=title,
        paper="(Implied: no other motion of the figure is named, and none that is chaotic.)",
        counted=f"area of the cells that rub which are {words}",
        threshold=SHARES,
        reason="a figure of a motion that the text does not name would show it; rims may",
        roles=(role,),
        measure=measure,
    )
