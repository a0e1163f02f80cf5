"""The program behind verdict_counts.sh, which says what it does."""

import collections
import concurrent.futures
import os
import re
import subprocess
import tempfile

from command import run_program
from rubplot import csv_table
from rubplot.failure import Failure

COLUMNS = ("file", "class", "order")
VERDICT = re.compile(r"^motion +((?:subharmonic 1/\d+)|[a-z_]+)", re.MULTILINE)


def label(row):
    """Class of a motion in the labels, with the order of a subharmonic."""
    return f"subharmonic 1/{row['order']}" if row["class"] == "subharmonic" else row["class"]


def verdict(text):
    """The same from what rubscope prints; empty where it says none."""
    found = VERDICT.search(text)
    return found.group(1) if found else ""


def judged(rubscope, directory, row):
    """The verdict of rubscope on one recording."""
    with tempfile.TemporaryDirectory() as work:
        command = [rubscope, os.path.join(directory, row["file"]), "--instrument",
                   os.path.join(directory, "instrument.yaml"), "--output", os.path.join(work, "scope")]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        found = verdict(done.stdout)
        if done.returncode != 0 or not found:
            raise Failure(f"{' '.join(command)} ends with {done.returncode}: {done.stderr.strip()}")
        return found


def counts(labels, verdicts):
    """{(label, verdict): how many}, sorted."""
    return dict(sorted(collections.Counter(zip(labels, verdicts)).items()))


def main(arguments):
    rubscope, directory = arguments
    rows = list(csv_table.read_table(os.path.join(directory, "labels.csv"), *COLUMNS))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
        verdicts = list(threads.map(lambda row: judged(rubscope, directory, row), rows))
    print("label,verdict,recordings")
    for (said, found), count in counts(map(label, rows), verdicts).items():
        print(f"{said},{found},{count}")


if __name__ == "__main__":
    run_program(main, usage="verdict_counts.sh RUBSCOPE SET", least=2, most=2)
