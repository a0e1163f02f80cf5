"""compared_results.py BEFORE AFTER: how do the results of two versions in these directories differ in what both have?

Comments of files, columns of tables, keys of config.yaml and files that only one of them has are named, and are no
difference. Prints `same`, `named`, `rounding` (numbers that differ by at most 1e-9 of the greatest one of their unit in
the table) or `different`, the first of these that holds, and then a line for every thing that is named or differs.
"""

import csv
import math
import os

from command import run_program

VERDICTS = ("same", "named", "rounding", "different")
LEAST_CHANGE = 1e-9


def compared(before, after):
    """(verdict, lines) of two directories."""
    files = [_files_below(directory) for directory in (before, after)]
    found = []
    for name in sorted(files[0].keys() ^ files[1].keys()):
        found.append(("named" if name in files[1] else "different", f"{name}: only {'after' if name in files[1] else 'before'}"))
    for name in sorted(files[0].keys() & files[1].keys()):
        texts = [_text(folder[name]) for folder in files]
        if texts[0] != texts[1]:
            compare = {".csv": _compare_tables, ".yaml": _compare_keys}.get(os.path.splitext(name)[1], _compare_lines)
            found += [(verdict, f"{name}: {line}") for verdict, line in compare(*(_without_comments(text) for text in texts))]
    verdict = max((verdict for verdict, _ in found), key=VERDICTS.index, default="same")
    return verdict, [line for _, line in found]


def _files_below(directory):
    return {os.path.relpath(os.path.join(folder, name), directory): os.path.join(folder, name)
            for folder, _, names in os.walk(directory) for name in names}


def _text(path):
    with open(path, encoding="utf-8", errors="replace", newline="") as file:
        return file.read()


def _without_comments(text):
    return [line for line in text.splitlines() if line and not line.startswith("#")]


def _compare_lines(before, after):
    if before != after:
        yield "different", f"{(before or [''])[0]} -> {(after or [''])[0]}"


def _compare_keys(before, after):
    """The printed configuration: what a default or another way of writing an axis adds is no difference."""
    if before != after:
        gone, new = ([line.strip() for line in one if line not in other] for one, other in ((before, after), (after, before)))
        yield "named", f"gone {gone}, new {new}"


def _compare_tables(before, after):
    rows = [list(csv.reader(lines)) for lines in (before, after)]
    if not rows[0] or not rows[1]:
        yield from _compare_lines(before, after)
        return
    tables = [{name: [row[i] for row in table[1:]] for i, name in enumerate(table[0])} for table in rows]
    for one, other, verdict, word in ((*tables, "different", "gone"), (*tables[::-1], "named", "new")):
        if only := [name for name in one if name not in other]:
            yield verdict, f"columns {word}: {', '.join(only)}"
    if len(rows[0]) != len(rows[1]):
        yield "different", f"{len(rows[0]) - 1} rows -> {len(rows[1]) - 1}"
        return
    scales = _scales(tables[0])
    for name in tables[0]:
        if name in tables[1]:
            yield from _compare_column(name, tables[0][name], tables[1][name], scales[_unit(name)])


def _compare_column(name, before, after, scale):
    moved = [i for i, (old, new) in enumerate(zip(before, after)) if old != new]
    if not moved:
        return
    change = max(_change(before[i], after[i], scale) for i in moved)
    first = f"row {moved[0] + 1}: {before[moved[0]] or 'nothing'} -> {after[moved[0]] or 'nothing'}"
    extent = f", by up to {change:.1e} of {scale:.3g}" if math.isfinite(change) else ""
    yield ("rounding" if change <= LEAST_CHANGE else "different"), f"{name} in {len(moved)} of {len(before)} rows{extent}; {first}"


def _change(before, after, scale):
    numbers = [_number(text) for text in (before, after)]
    if None in numbers or not all(map(math.isfinite, numbers)):
        return math.inf
    return abs(numbers[0] - numbers[1]) / (scale or 1)


def _unit(name):
    """m of peak_displacement_m, n_per_m of stiffness_n_per_m."""
    words = name.split("_")
    return "_".join(words[words.index("per") - 1:]) if "per" in words[1:] else words[-1]


def _scales(table):
    """Greatest magnitude of each unit, the word that names of columns end with."""
    scales = {_unit(name): 0.0 for name in table}
    for name, texts in table.items():
        numbers = [abs(number) for number in map(_number, texts) if number is not None and math.isfinite(number)]
        scales[_unit(name)] = max([scales[_unit(name)], *numbers])
    return scales


def _number(text):
    try:
        return float(text)
    except ValueError:
        return None


def main(arguments):
    verdict, lines = compared(*arguments)
    print(verdict, *lines, sep="\n")


if __name__ == "__main__":
    run_program(main, usage="compared_results.py BEFORE AFTER", least=2, most=2)
