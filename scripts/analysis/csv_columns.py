"""csv_columns.py FILE.csv NAME...: the cells of these columns, one row of the table per line, parted by commas."""


from command import run_program
from rubplot import csv_table


def main(arguments):
    path, *names = arguments
    for row in csv_table.read_table(path, *names):
        print(",".join(row[name] for name in names))


if __name__ == "__main__":
    run_program(main, usage="csv_columns.py FILE.csv NAME...", least=2)
