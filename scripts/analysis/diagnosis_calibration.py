"""Calibration of rubdiagnose from the tables of studies/diagnosis/diagnosis_calibration.

diagnosis_calibration.py TABLE.csv ...: how often statements of each probability are right, how often the right candidate
comes first, a confusion table, causes that are no candidate, and whether true numbers lie evenly in their posteriors.
"""

import csv
import sys
from collections import Counter, defaultdict

CANDIDATES = ("no_rub", "one_side", "two_sides", "annular", "annular_offset")
TELLING = 0.79  # share of the nearest cases that are of one candidate, from which candidates differ in a recording


def rows_of(paths):
    for path in paths:
        with open(path, newline="", encoding="utf-8") as table:
            header = None
            for cells in csv.reader(table):
                if cells[0] == "machine":
                    header = cells
                else:
                    # Recordings of no candidate have no ranks.
                    yield dict(zip(header, cells))


def probabilities(row):
    none = float(row["none"])
    stated = {name: (1 - none) * float(row[name]) for name in CANDIDATES}
    return {**stated, "none": none}


def truth_of(row):
    return row["truth"] if row["truth"] in CANDIDATES else "none"


def print_statements(rows):
    bins = defaultdict(list)
    for row in rows:
        for name, stated in probabilities(row).items():
            bins[min(9, int(10 * stated))].append((stated, name == truth_of(row)))
    print("statements: probability, how many, mean, share that is right, binomial deviation")
    for k, found in sorted(bins.items()):
        mean = sum(stated for stated, _ in found) / len(found)
        right = sum(is_true for _, is_true in found) / len(found)
        print(f"  {10 * k:3d}-{10 * k + 10} %  {len(found):5d}  {mean:.3f}  {right:.3f}  {(mean * (1 - mean) / len(found)) ** 0.5:.3f}")


def print_firsts(rows):
    known = [row for row in rows if truth_of(row) != "none"]
    first = {id(row): max(probabilities(row), key=probabilities(row).get) for row in rows}
    telling = [row for row in known if float(row["share_of_nearest"]) >= TELLING]
    for name, some in (("all of candidates", known), ("where candidates differ", telling)):
        print(f"right first, {name}: {sum(first[id(row)] == row['truth'] for row in some)} of {len(some)}")
    print(f"right by the rule: {sum(row['rule'] == (row['truth'] if truth_of(row) != 'none' else 'no_rub') for row in rows)} of {len(rows)}")
    print("truth, and what came first:")
    for name in CANDIDATES:
        print(f"  {name:<15}", dict(Counter(first[id(row)] for row in known if row["truth"] == name)))
    print("causes that are no candidate, and what came first:")
    for name in sorted({row["truth"] for row in rows} - set(CANDIDATES)):
        print(f"  {name:<20}", dict(Counter(first[id(row)] for row in rows if row["truth"] == name)))


def print_ranks(rows):
    print("ranks of true numbers in five equal parts, and chi-square of 4 degrees (9.5 at 5 %):")
    for name in [name for name in rows[0] if name.startswith("rank_of_")]:
        ranks = [float(row[name]) for row in rows if row.get(name) and row["truth"] != "no_rub"]
        # A candidate whose cases weigh nothing says nothing of its numbers.
        ranks = [rank for rank in ranks if rank == rank]
        counts = [sum(min(4, int(5 * rank)) == k for rank in ranks) for k in range(5)]
        expected = len(ranks) / 5
        print(f"  {name[8:]:<22} {counts}  {sum((count - expected) ** 2 for count in counts) / expected:.1f}")


def main():
    rows = list(rows_of(sys.argv[1:]))
    if not rows:
        sys.exit("diagnosis_calibration.py: no rows")
    print_statements(rows)
    print_firsts(rows)
    print_ranks(rows)


if __name__ == "__main__":
    main()
