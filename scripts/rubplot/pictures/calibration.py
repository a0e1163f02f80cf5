"""Calibration of rubdiagnose: statements that are right, what came first, and ranks of true numbers."""

from rubplot.calibration import CANDIDATES, NONE, PARTS, Calibration
from rubplot.failure import Failure, require_readable
from rubplot.gnuplot import Picture
from rubplot.gnuplot_text import quoted
from rubplot.subcommand import Subcommand

ANSWERS = (*CANDIDATES, NONE)


def truths_of(calibration):
    return (*CANDIDATES, *calibration.other_truths())


def statements(calibration):
    """Mean, share that is right, half a 95 % interval of it, number."""
    for tenth in calibration.statements():
        yield f"{tenth.mean:.17g} {tenth.right:.17g} {1.96 * tenth.deviation:.17g} {tenth.count}"


def firsts(calibration):
    """Place of the answer, place of the truth from the top, number, share of the truth's recordings."""
    for row, truth in enumerate(truths_of(calibration)):
        counts = calibration.firsts(truth)
        for column, answer in enumerate(ANSWERS):
            yield f"{column} {-row} {counts[answer]} {counts[answer] / max(1, sum(counts.values())):.17g}"


def ranks(calibration):
    """A block of parts of each number: middle of the part, count over the one that is expected."""
    for name in calibration.rank_names():
        counts = calibration.counts(name)
        expected = sum(counts) / PARTS or 1
        for part, count in enumerate(counts):
            yield f"{(part + 0.5) / PARTS:.17g} {count / expected:.17g}"
        yield "\n"


def settings(calibration):
    """Assignments for the template: names, and the band that 95 % of the counts lie in, of the number with the fewest."""
    names = [name.removeprefix("rank_of_").rsplit("_", 1)[0] if "_per_" not in name else "stiffness" for name in calibration.rank_names()]
    for array, words in (("answer", ANSWERS), ("truth", truths_of(calibration)), ("number", names)):
        yield f"array {array}[{len(words)}]"
        for place, word in enumerate(words, 1):
            yield f"{array}[{place}] = {quoted(word.replace('_', ' '))}"
    expected = min(sum(calibration.counts(name)) for name in calibration.rank_names()) / PARTS
    yield f"band = {1.96 * ((1 - 1 / PARTS) / max(1, expected)) ** 0.5:.17g}"


def picture(given):
    require_readable(given.source)
    calibration = Calibration.of_tables([given.source])
    if not calibration.rows:
        raise Failure("no recording to count")
    return Picture(
        "calibration.gp",
        (given.heading,),
        {
            "statements": statements(calibration),
            "firsts": firsts(calibration),
            "ranks": ranks(calibration),
            "settings.gp": settings(calibration),
        },
    )


SUBCOMMAND = Subcommand(
    name="calibration",
    summary="statements of rubdiagnose against what is true (a study)",
    description="""Draws the table of studies/diagnosis/diagnosis_calibration: how often statements of each probability are
right, what came first of each truth, and where true numbers lie in their posterior distributions.""",
    source="TABLE.csv",
    heading="Calibration of rubdiagnose",
    picture=picture,
    examples=("results/diagnosis/calibration.csv --output calibration.png",),
)
