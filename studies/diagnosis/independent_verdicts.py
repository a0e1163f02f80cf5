#!/usr/bin/env python3
"""Diagnoses the recordings of independent_recordings.py and counts what rubdiagnose says of them.

Usage: independent_verdicts.py RUBDIAGNOSE DIRECTORY [OPTION...]

OPTIONs go to rubdiagnose; without them its defaults count. Each answer is kept in DIRECTORY/answers, so that an
interrupted count goes on, and recordings without an answer yet are left out of the tables. With RUBDIAGNOSE `-`
only the answers that are there are counted. Prints tables in Markdown: first answers by truth, shares of right
ones, and stated probabilities against the share that was right.
"""

import csv
import pathlib
import subprocess
import sys

RUBS = ("one_side", "two_sides", "annular", "annular_offset")
KINDS = {"one_side": "one side", "two_sides": "two sides", "annular": "round", "annular_offset": "round",
         "no_rub": "no rub", "none_of_these": "none"}
COLUMNS = ("one side", "two sides", "round", "no rub", "none")


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def answer(program, directory, recording, options):
    """Probability of each kind; a centred and an offset round stop are one."""
    made = directory / "answers" / recording["recording"]
    if not (made / "probabilities.csv").exists():
        if program == "-":
            return None
        machine = directory / f"m{recording['machine']}"
        machine.mkdir(exist_ok=True)
        (machine / "machine.yaml").write_text((directory / f"machine_{recording['machine']}.yaml").read_text())
        stem = directory / recording["recording"]
        command = [program, f"{stem}.csv", "--instrument", f"{stem}.yaml", "--machine", machine / "machine.yaml",
                   "--table", directory / "cases", "--output", made, "--quiet", "--progress", "never", *options]
        subprocess.run(command, check=True)
    shares = dict.fromkeys(COLUMNS, 0.0)
    for row in rows_of(made / "probabilities.csv"):
        shares[KINDS[row["candidate"]]] += float(row["probability"])
    return shares


def right_kind(cause):
    """Kind that is right: a foreign cause is none of the candidates."""
    return KINDS.get(cause, "none")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def first_of(shares):
    return max(shares, key=shares.get)


def confusion(judged):
    causes = sorted({cause for cause, _ in judged}, key=lambda cause: (cause not in RUBS, cause))
    rows = []
    for cause in causes:
        firsts = [first_of(shares) for found, shares in judged if found == cause]
        rows.append([cause.replace("_", " "), len(firsts)] + [firsts.count(kind) or "" for kind in COLUMNS])
    return table(["truth", "recordings"] + list(COLUMNS), rows)


def shares_right(judged):
    """Counts of right answers, of those that are right about rub or not, and of those that are wrong and sure."""
    rows = []
    for name, of in (("rubs", lambda cause: cause in RUBS), ("no rub", lambda cause: cause == "no_rub"),
                     ("foreign causes", lambda cause: cause not in RUBS and cause != "no_rub")):
        part = [(right_kind(cause), shares) for cause, shares in judged if of(cause)]
        right = sum(first_of(shares) == kind for kind, shares in part)
        told = sum((first_of(shares) in ("no rub", "none")) == (name != "rubs") for _, shares in part)
        sure = sum(max(shares.values()) >= 0.9 and first_of(shares) != kind for kind, shares in part)
        rows.append([name, len(part), right, told, sure])
    return table(["truth", "recordings", "right first", "rub or not is right", "wrong and 90 % or more"], rows)


def calibration(judged):
    """Stated probabilities of all kinds in steps of a fifth, and how often they were right."""
    rows = []
    for low in (0, 0.2, 0.4, 0.6, 0.8):
        said = [(share, kind == right_kind(cause)) for cause, shares in judged for kind, share in shares.items()
                if low <= share < low + 0.2 or (share >= 1 and low == 0.8)]
        if said:
            rows.append([f"{100 * low:.0f} to {100 * low + 20:.0f} %", len(said),
                         f"{sum(share for share, _ in said) / len(said):.2f}",
                         f"{sum(good for _, good in said) / len(said):.2f}"])
    return table(["stated", "statements", "mean", "right"], rows)


def main(program, directory, options):
    judged = []
    for recording in rows_of(directory / "truth.csv"):
        shares = answer(program, directory, recording, options)
        if shares:
            judged.append((recording["cause"], shares))
    print(confusion(judged), shares_right(judged), calibration(judged), sep="\n\n")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:])
