"""The program behind aperiodic_cells.sh, which says what it does."""

import os

from command import run_program
from rubplot import csv_table

CLASSES = ("quasi_periodic", "chaotic", "unsettled")
COLUMNS = ("speed_hz", "whirl_ratio", "class", "lyapunov_per_revolution", "status", "comb_spacing")


def aperiodic_lines(path):
    """The cells of a map that are neither periodic, nor ovals, nor without contact, one line of CSV each."""
    name = os.path.basename(os.path.dirname(os.path.abspath(path)))
    for row in csv_table.read_table(path, *COLUMNS):
        if row["comb_spacing"] or row["class"] not in CLASSES:
            continue
        exponent = csv_table.number(row, "lyapunov_per_revolution")
        yield ",".join((
            name,
            "%g" % csv_table.number(row, "speed_hz"),
            "" if not row["whirl_ratio"] else "%.3f" % csv_table.number(row, "whirl_ratio"),
            row["class"],
            "" if exponent is None else "%.2g" % exponent,
            row["status"],
        ))


def main(arguments):
    print("map,speed_hz,whirl_ratio,class,lyapunov_per_revolution,status")
    for path in arguments:
        for line in aperiodic_lines(path):
            print(line)


if __name__ == "__main__":
    run_program(main, usage="aperiodic_cells.sh MAP.csv...")
