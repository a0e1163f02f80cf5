"""findings_table.py FINDINGS.txt: the table of docs/validation/ishibashi_kawai.md, of the record that check_findings.sh writes:
the number and verdict of the first machine, verdicts of the others, and below it how many there are of each."""

import collections
import re
import sys

from markdown_table import table

VERDICTS = ("holds", "partly", "not reproduced")


def findings(text):
    """Pairs of a finding's name and of its (machine, number, verdict)."""
    found = []
    for block in re.split(r"\n\s*\n", text):
        machines = re.findall(r"^ {3}([^|\n]*?) *\| *(.*?) *\| *(holds|partly|not reproduced)$", block, re.MULTILINE)
        if machines:
            found.append((block.lstrip().split("\n")[0], machines))
    return found


def as_table(found):
    names = list(dict.fromkeys(name for _, machines in found for name, _, _ in machines))
    rows, counts = [], {name: collections.Counter() for name in names}
    for finding, machines in found:
        of = {name: (number, verdict) for name, number, verdict in machines}
        cells = [finding]
        for name in names:
            number, verdict = of.get(name, ("", ""))
            counts[name][verdict] += bool(verdict)
            cells.append(f"{verdict}: {number}" if name == names[0] and number else verdict)
        rows.append(cells)
    rows.append(["in all"] + [", ".join(f"{counts[name][verdict]} {verdict}" for verdict in VERDICTS) for name in names])
    return table(["finding", *names], rows)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        print(as_table(findings(file.read())), end="")
