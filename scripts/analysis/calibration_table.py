"""calibration_table.py statements|firsts TABLE.csv: a table of docs/validation/which_rub.md, of what the study
diagnosis_calibration wrote."""

import sys

from markdown_table import table
from rubplot.calibration import CANDIDATES, NONE, Calibration

WORDS = {"no_rub": "no rub", "one_side": "one side", "two_sides": "two sides", "annular_offset": "annular, offset"}


def word(name):
    return WORDS.get(name, name.replace("_", " "))


def statements(calibration):
    """How often statements of each tenth of probability are right."""
    rows = []
    for tenth in calibration.statements():
        least = 10 * min(9, int(10 * tenth.mean))
        rows.append([f"{least} to {least + 10} %", tenth.count, f"{tenth.mean:.3f}", f"{tenth.right:.3f}", f"{tenth.deviation:.3f}"])
    return table(["stated", "statements", "mean", "right", "binomial deviation"], rows)


def firsts(calibration):
    """The candidate that comes first, for each truth."""
    names = (*CANDIDATES, NONE)
    rows = []
    for truth in (*CANDIDATES, *calibration.other_truths()):
        counts = dict(calibration.firsts(truth))
        rows.append([word(truth), *(counts.get(name, "") for name in names)])
    return table(["truth", "first: " + word(names[0]), *map(word, names[1:])], rows)


if __name__ == "__main__":
    print({"statements": statements, "firsts": firsts}[sys.argv[1]](Calibration.of_tables(sys.argv[2:])), end="")
