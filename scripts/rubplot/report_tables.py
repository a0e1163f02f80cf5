"""The tables of a rotor report (rubtrace --rotor-report) as the pictures of it need them."""

import os
import re

from rubplot import csv_table
from rubplot.failure import Failure


def path_of(directory, name):
    return os.path.join(directory, name)


def notes(directory):
    """The remarks of each picture, in a dict from its name to a list; the operating range under 'operating'."""
    found = {}
    for row in csv_table.read_table(path_of(directory, "report_notes.csv"), "picture", "note", "from_hz", "to_hz"):
        found.setdefault(row["picture"], []).append(row)
    return found


def operating_hz(directory):
    """Both ends of the operating range, None where there is none."""
    for row in notes(directory).get("operating", []):
        ends = [csv_table.number(row, name) for name in ("from_hz", "to_hz")]
        return None if None in ends else tuple(ends)
    return None


def note_text(directory, picture):
    """All remarks on a picture in one line, with the micrometres of a picture in place of a terminal's."""
    text = "; ".join(row["note"] for row in notes(directory).get(picture, []))
    return re.sub(r"(?<=\d) um\b", " µm", text)


def require(directory, name, picture):
    """The path of a table; Failure with the reason where the report left it out."""
    path = path_of(directory, name)
    if not os.path.exists(path) and os.path.exists(path_of(directory, "report_notes.csv")):
        reason = note_text(directory, picture)
        if reason:
            raise Failure(f"{directory}: {picture} {reason}")
    return path


def numbers(path, *names):
    """The rows of a table with these columns as numbers or None, all others as text."""
    return [{**row, **{name: csv_table.number(row, name) for name in names}} for row in csv_table.read_table(path, *names)]


def bearings(directory):
    """(name, position_m) of the bearings; nothing where there are none."""
    path = path_of(directory, "bearing_loads.csv")
    return [(row["bearing"], row["position_m"]) for row in numbers(path, "position_m")] if os.path.exists(path) else []
