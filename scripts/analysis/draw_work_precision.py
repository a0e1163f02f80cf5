"""The program behind work_precision.sh, which says what it does."""

import os
import tempfile

import gnuplot
import work_precision
from command import require_readable, run_program


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    table, output = (os.path.abspath(name) for name in arguments[:2])
    require_readable(table)
    chart = work_precision.read_chart(table)
    os.makedirs(os.path.dirname(output), exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        data = os.path.join(work, "data")
        with open(data, "w", encoding="utf-8") as file:
            file.writelines(work_precision.data_lines(chart))
        with open(data + ".gp", "w", encoding="utf-8") as file:
            file.writelines(work_precision.settings(chart))
        gnuplot.draw("work_precision.gp", data, output + ".png", arguments[2], str(len(chart.titles)))


if __name__ == "__main__":
    run_program(main, usage="work_precision.sh TABLE.csv OUTPUT_BASENAME HEADING", least=3, most=3)
