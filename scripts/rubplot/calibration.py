"""Calibration of probabilities: how often statements are right, and what they say of each truth."""

from collections import Counter, defaultdict
from dataclasses import dataclass

from rubplot import csv_table

CANDIDATES = ("no_rub", "one_side", "two_sides", "annular", "annular_offset")
NONE = "none"
PARTS = 5  # of the unit interval, in which ranks are counted

# Share of one candidate among the nearest cases, by how likely each is as large as the recording, from which candidates
# differ in it.
TELLING = 0.79


@dataclass(frozen=True)
class Statements:
    """Statements of probabilities in a tenth of the unit interval: their number, their mean, and the share that is right."""

    count: int
    mean: float
    right: float

    @property
    def deviation(self):
        """Standard deviation of the share, were the mean its probability (binomial)."""
        return (self.mean * (1 - self.mean) / self.count) ** 0.5


class Calibration:
    """Rows of studies/diagnosis/diagnosis_calibration."""

    def __init__(self, rows):
        self.rows = list(rows)

    @classmethod
    def of_tables(cls, paths):
        return cls(row for path in paths for row in csv_table.read_table(path, "truth", "none", "rule", "share_of_nearest", *CANDIDATES))

    def statements(self):
        """From the least likely tenth to the likeliest; a tenth without any is left out."""
        tenths = defaultdict(list)
        for row in self.rows:
            for name, stated in probabilities(row).items():
                tenths[min(9, int(10 * stated))].append((stated, name == truth_of(row)))
        for _, found in sorted(tenths.items()):
            count = len(found)
            yield Statements(count, sum(stated for stated, _ in found) / count, sum(right for _, right in found) / count)

    def of_candidates(self, telling=False):
        """Recordings of candidates; `telling`: those in which candidates differ."""
        return [row for row in self.rows if truth_of(row) != NONE and (not telling or float(row["share_of_nearest"]) >= TELLING)]

    def other_truths(self):
        return sorted({row["truth"] for row in self.rows} - set(CANDIDATES))

    def firsts(self, truth):
        """Answers that came first, and how often, in recordings of this truth."""
        return Counter(first_of(row) for row in self.rows if row["truth"] == truth)

    def rank_names(self):
        return [name for name in self.rows[0] if name.startswith("rank_of_")]

    def ranks(self, name, truth=None):
        """Shares of the posterior distributions below the true numbers, of recordings whose cause has such a number.

        `truth`: of this cause alone.
        """
        return [float(row[name]) for row in self.rows if row[name] and truth in (None, row["truth"])]

    def equal_cases(self):
        """How many equal cases the posterior of each true cause that rubs rests on, in rising order."""
        return sorted(float(row["effective_cases"]) for row in self.rows if truth_of(row) not in (NONE, "no_rub"))

    def counts(self, name):
        """How many true numbers lie in each part of their posterior distribution."""
        ranks = self.ranks(name)
        return [sum(min(PARTS - 1, int(PARTS * rank)) == part for rank in ranks) for part in range(PARTS)]

    def inside(self, name, truth=None, probability=0.95):
        """Share of the true numbers that lie in the interval that is said to hold them with this probability."""
        outside = (1 - probability) / 2
        ranks = self.ranks(name, truth)
        return sum(outside <= rank <= 1 - outside for rank in ranks) / len(ranks) if ranks else float("nan")


def probabilities(row):
    none = float(row["none"])
    return {**{name: (1 - none) * float(row[name]) for name in CANDIDATES}, NONE: none}


def truth_of(row):
    return row["truth"] if row["truth"] in CANDIDATES else NONE


def first_of(row):
    stated = probabilities(row)
    return max(stated, key=stated.get)


def chi_square(counts):
    """Chi-square of counts that should be equal."""
    expected = sum(counts) / len(counts)
    return sum((count - expected) ** 2 for count in counts) / expected if expected else 0.0
