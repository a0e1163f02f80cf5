"""The kinds of motion and their colours, as `rubsweep --motion-kinds` prints them: motion_kinds.csv is that table."""

import csv
import os
import re
from dataclasses import dataclass

_TABLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "motion_kinds.csv")
LARGEST_NAMED_ORDER = 8


@dataclass(frozen=True)
class MotionKind:
    name: str
    label: str
    colour: str
    hatched: bool


def _read():
    with open(_TABLE, encoding="utf-8", newline="") as file:
        return tuple(MotionKind(row["name"], row["label"], row["colour"], row["hatched"] == "1")
                     for row in csv.DictReader(file))


KINDS = _read()


def class_and_order(name, order):
    """The kind of a class and the order of a motion alone."""
    return f"{name}_{min(int(order), LARGEST_NAMED_ORDER)}" if name == "subharmonic" and order else name


def kind_of(row):
    """The kind of a row of map.csv. Maps of older programs have no such column, and show class and order alone."""
    return row["kind"] if "kind" in row else class_and_order(row["class"], row["order"])


def may_be_drawn(kind):
    """Whether the word may become a part of gnuplot's commands."""
    return re.fullmatch(r"[a-z_0-9]+", kind) is not None


def gnuplot_arrays():
    """The table for gnuplot: kinds, and the arrays kind, legend and colour."""
    lines = [f"kinds = {len(KINDS)}"]
    for array, member in (("kind", "name"), ("legend", "label"), ("colour", "colour")):
        words = ", ".join(f'"{getattr(kind, member)}"' for kind in KINDS)
        lines.append(f"array {array}[kinds] = [{words}]")
    return "\n".join(lines) + "\n"
