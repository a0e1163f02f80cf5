"""Tables of Markdown, from rows of words or from the columns that a program prints."""

import re
import sys


def table(headings, rows):
    """The text of a table; a bar within a cell is escaped."""
    lines = [headings, ["---"] * len(headings), *rows]
    return "".join("|" + "".join(f" {cell} |".replace("  ", " ") for cell in (str(cell).replace("|", "\\|") for cell in line)) + "\n"
                   for line in lines)


def of_columns(text, pattern, columns):
    """The table of lines of `text` that match `pattern`, with `columns` given as pairs of a heading and a column counted from 1;
    without the folder and the ending of a configuration."""
    lines = [re.sub(r"\bconfigs/(\S*)\.yaml", r"`\1`", line).split() for line in text.splitlines() if re.search(pattern, line)]
    return table([heading for heading, _ in columns], [[line[column - 1] for _, column in columns] for line in lines])


if __name__ == "__main__":
    # markdown_table.py PATTERN HEADING=COLUMN...: the table of what comes on stdin.
    pairs = [argument.rsplit("=", 1) for argument in sys.argv[2:]]
    print(of_columns(sys.stdin.read(), sys.argv[1], [(heading, int(column)) for heading, column in pairs]), end="")
