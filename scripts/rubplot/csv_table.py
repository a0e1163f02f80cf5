"""Reads the tables that the programs write: CSV with comment lines and a header, columns by name and never by number."""

import csv
import hashlib
import os
import re
import sys

from rubplot.failure import open_regular


class TableError(Exception):
    """A table that is not what the program writes; the message names file and line."""


def read_table(path, *needed):
    """Yields the rows of the CSV file `path` as they are read, each a dict from the column's name to its text.

    Lines that begin with # and empty lines are passed over. Raises TableError where the table is not as it was written,
    where there is no header, where one of the `needed` columns is missing, or where a row has not as many cells as the
    header.
    """
    require_whole(path)
    with open_regular(path, encoding="utf-8", errors="replace", newline="") as file:
        lines = _NumberedLines(file)
        try:
            yield from _rows(path, lines, needed)
        except csv.Error as error:
            raise TableError(f"{path}:{lines.number}: {error}") from None


def _rows(path, lines, needed):
    header = None
    for cells in csv.reader(lines):
        if header is None:
            header = cells
            for name in needed:
                if name not in header:
                    raise TableError(f"{path}:{lines.number}: no column '{name}'")
        elif len(cells) != len(header):
            raise TableError(f"{path}:{lines.number}: {len(cells)} cells, {len(header)} columns")
        else:
            yield dict(zip(header, cells))
    if header is None:
        raise TableError(f"{path}: no header")


def require_whole(path):
    """Raises TableError where a table is not what its checksum says, the SHA-256 of all lines but its own.

    Tables that have none, as those of earlier versions and those written by hand, are taken as they are, with a warning.
    """
    total, said, ours, cr_lf = hashlib.sha256(), None, False, None
    with open_regular(path, "rb") as file:
        for line in file:
            # Lines of a checkout for another system end in CR LF, which changes no number.
            cr_lf = line.endswith(b"\r\n") if cr_lf is None else cr_lf
            if cr_lf and line.endswith(b"\r\n"):
                line = line[:-2] + b"\n"
            if said is None and line.startswith(b"# sha256 "):
                said = line.split()[2:]
            else:
                ours = ours or re.match(rb"# format \d", line) is not None
                total.update(line)
    if said is None and ours and not str(path).endswith(".partial.csv"):
        raise TableError(f"{path}: is not as it was written: its checksum is missing")
    if said is None:
        _warn_once(path)
    elif said != [total.hexdigest().encode()]:
        raise TableError(f"{path}: is not as it was written: its sha256 is {total.hexdigest()}")


def head(path):
    """A dict from the first word of every comment before the header to what is behind it: digest, title, parameter ..."""
    found = {}
    with open_regular(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            if not line.startswith("#"):
                break
            word, _, rest = line[1:].strip().partition(" ")
            found.setdefault(word, rest.strip())
    return found


def digest(path):
    """The study that the first comments of a table name, or None."""
    return head(path).get("digest")


def number(row, name):
    """The number in column `name` of a row, or None where the cell is empty. Raises TableError for anything else."""
    text = row[name]
    try:
        return float(text) if text else None
    except ValueError:
        raise TableError(f"column '{name}': '{text}' is no number") from None


def between(rows, name, low=None, high=None):
    """The rows whose number in column `name` lies between `low` and `high`, both included; None leaves an end open."""
    return (
        row
        for row in rows
        if (low is None or number(row, name) >= low) and (high is None or number(row, name) <= high)
    )


_WARNED = set()


def _warn_once(path):
    if path not in _WARNED:
        _WARNED.add(path)
        print(f"{_program()}: {path} has no checksum in its head: it is taken as it is", file=sys.stderr)


def _program():
    """The name that the user called, of a package that of its directory."""
    path = os.path.abspath(sys.argv[0])
    return os.path.basename(os.path.dirname(path) if os.path.basename(path) == "__main__.py" else path)


class _NumberedLines:
    """The lines of a file without comments and empty ones; `number` is that of the line last given."""

    def __init__(self, file):
        self._file = file
        self.number = 0

    def __iter__(self):
        for line in self._file:
            self.number += 1
            if not line.startswith("#") and line.strip("\r\n"):
                yield line
