"""identification.py IDENTIFICATION.csv QUANTITY: its value and the number of its sensor as rubtrace found them, the first
where several sensors have one."""

import csv_table
from command import Failure, run_program


def find(rows, quantity):
    """The texts of value and sensor."""
    for row in rows:
        if row["quantity"] == quantity:
            return row["value"], row["sensor"]
    raise Failure(f"no quantity '{quantity}'")


def main(arguments):
    path, quantity = arguments
    print(*find(csv_table.read_table(path, "quantity", "sensor", "value"), quantity))


if __name__ == "__main__":
    run_program(main, usage="identification.py IDENTIFICATION.csv QUANTITY", least=2, most=2)
