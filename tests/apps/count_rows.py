"""count_rows.py FILE.csv CONDITION: how many rows of a table make the Python expression true. Its names are the columns
(`class` is class_), numbers where the cell is one, text elsewhere; sqrt is at hand."""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scripts"))
from rubplot import csv_table  # noqa: E402


def value(text):
    try:
        return float(text)
    except ValueError:
        return text


def main(path, condition):
    compiled = compile(condition, "condition", "eval")
    rows = ({("class_" if name == "class" else name): value(cell) for name, cell in row.items()}
            for row in csv_table.read_table(path))
    print(sum(bool(eval(compiled, {"sqrt": math.sqrt}, row)) for row in rows))


main(*sys.argv[1:])
