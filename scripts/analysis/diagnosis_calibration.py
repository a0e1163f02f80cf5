"""Calibration of rubdiagnose from the tables of studies/diagnosis/diagnosis_calibration.

PYTHONPATH=scripts diagnosis_calibration.py TABLE.csv ...: how often statements of each probability are right, how often the
right candidate comes first, a confusion table, causes that are no candidate, and whether true numbers lie evenly in their
posteriors.
"""

import sys

from rubplot.calibration import CANDIDATES, NONE, Calibration, chi_square, first_of, truth_of


def print_statements(calibration):
    print("statements: how many, mean, share that is right, binomial deviation")
    for tenth in calibration.statements():
        print(f"  {tenth.count:5d}  {tenth.mean:.3f}  {tenth.right:.3f}  {tenth.deviation:.3f}")


def print_firsts(calibration):
    for name, telling in (("all of candidates", False), ("where candidates differ", True)):
        rows = calibration.of_candidates(telling)
        print(f"right first, {name}: {sum(first_of(row) == row['truth'] for row in rows)} of {len(rows)}")
    others = [row for row in calibration.rows if truth_of(row) == NONE]
    print(f"none of these or no rub first, of no candidate: {sum(first_of(row) in (NONE, 'no_rub') for row in others)} of {len(others)}")
    by_rule = sum(row["rule"] == (row["truth"] if truth_of(row) != NONE else "no_rub") for row in calibration.rows)
    print(f"right by the rule: {by_rule} of {len(calibration.rows)}")
    print("truth, and what came first:")
    for name in (*CANDIDATES, *calibration.other_truths()):
        print(f"  {name:<20}", dict(calibration.firsts(name)))


def print_ranks(calibration):
    # Bonferroni's bound: were all even, one of nine would be above it in 5 % of such tables.
    print("ranks of true numbers in five equal parts, chi-square of 4 degrees (at 5 %: 9.5 of one, 14.6 of the largest of nine),")
    print("and share in the intervals of 95 %, of all and of each cause that rubs:")
    for name in calibration.rank_names():
        counts = calibration.counts(name)
        inside = "  ".join(f"{calibration.inside(name, truth):.3f}" for truth in (None, *CANDIDATES[1:]))
        print(f"  {name.removeprefix('rank_of_'):<22} {counts}  {chi_square(counts):.1f}  {inside}")
    few = calibration.equal_cases()
    print(f"equal cases of these posteriors: a tenth below {few[len(few) // 10]:.0f}, half below {few[len(few) // 2]:.0f}")


def main():
    calibration = Calibration.of_tables(sys.argv[1:])
    if not calibration.rows:
        sys.exit("diagnosis_calibration.py: no rows")
    print_statements(calibration)
    print_firsts(calibration)
    print_ranks(calibration)


if __name__ == "__main__":
    main()
