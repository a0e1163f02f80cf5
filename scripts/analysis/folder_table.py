"""folder_table.py CHECK_LAYERS.sh LIB: the table of the library's folders in docs/architecture.md, of the rules that
check_layers.sh checks and of the comments above them."""

import os
import re
import sys

from markdown_table import table
from rubplot.failure import Failure

STOREYS = ("core", "maps", "analysis", "measurement", "ring")
ENTRY = re.compile(r"((?:^  #.*\n)*)^  \[([^\]]+)\]='([^']*)'$", re.MULTILINE)


def folders(script):
    """(folder, folders that it stands on, what it holds) of every rule."""
    rules = script[script.index("declare -A below"):]
    for comment, folder, below in ENTRY.findall(rules[:rules.index("\n)")]):
        holds = " ".join(line.strip(" #") for line in comment.splitlines())
        if not holds:
            raise Failure(f"nothing is said of the folder {folder}")
        yield folder, below.split(), holds


def storey_of(folder, lib):
    if folder == ".":
        return "core"
    for storey in STOREYS:
        if os.path.isdir(os.path.join(lib, "rubsweep", storey, folder)) or storey == folder:
            return storey
    raise Failure(f"no storey of {lib} has a folder {folder}")


def as_table(script, lib):
    rows = {storey: [] for storey in STOREYS}
    for folder, below, holds in folders(script):
        storey = storey_of(folder, lib)
        name = storey if folder == "." or storey == folder else f"{storey}/{folder}"
        rows[storey].append([f"`{name}`", ", ".join(f"`{other}`" for other in below if other != "."), holds])
    return table(["folder of `lib/rubsweep`", "stands on", "holds"], [row for storey in STOREYS for row in rows[storey]])


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        print(as_table(file.read(), sys.argv[2]), end="")
