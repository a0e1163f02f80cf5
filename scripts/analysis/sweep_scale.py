"""The arithmetic behind sweep_scale.sh.

sweep_scale.py grid CELLS: numbers of speeds and whirl ratios whose product is CELLS, as nearly equal as can be.
sweep_scale.py row TIME MAP.csv: a row of the table; TIME holds "PEAK_KB USER_S SYSTEM_S" of the sweep.
"""

import math

from command import run_program
from rubplot import csv_table
from rubplot.failure import Failure


def grid(cells):
    """(speeds, whirl ratios), the speeds not fewer than the ratios."""
    ratios = math.isqrt(cells)
    while cells % ratios:
        ratios -= 1
    return cells // ratios, ratios


def table_row(peak_kb, seconds, rows):
    cells = rub = 0
    for row in rows:
        cells += 1
        rub += row["class"] != "non_contact"
    return "| %d | %.0f %% | %.1f | %.2f | %.0f |" % (cells, 100 * rub / cells, peak_kb * 1024 / 1e6, seconds, cells / seconds)


def main(arguments):
    if arguments[0] == "grid" and len(arguments) == 2:
        print(*grid(int(arguments[1])))
    elif arguments[0] == "row" and len(arguments) == 3:
        with open(arguments[1], encoding="utf-8") as file:
            # Before the figures GNU time writes a line where the exit code is not 0.
            peak_kb, user_s, system_s = map(float, file.read().split("\n")[-2].split())
        print(table_row(peak_kb, user_s + system_s, csv_table.read_table(arguments[2], "class")))
    else:
        raise Failure("neither grid nor row")


if __name__ == "__main__":
    run_program(main, usage="sweep_scale.py grid CELLS | row TIME MAP.csv", least=2, most=3)
