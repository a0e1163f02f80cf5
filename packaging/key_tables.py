"""Tables of keys, as the programs print them with --keys."""

import re

MARKER = "\n<!-- Made by packaging/reference_pages.py; what follows is not written by hand. -->\n"
_HEAD = "| key | meaning | allowed | default |\n|---|---|---|---|\n"


def rows(text):
    """Path, meaning, and what is allowed and the default, of each key that --keys prints."""
    lines = text.split("\n")
    return [(lines[i], lines[i + 1].strip(), *_facts(lines[i + 2].strip())) for i in range(0, len(lines) - 2, 3)]


def units(text):
    """Pairs of the last name of a key and its unit, of each key that has one."""
    found = [re.search(r"; in ([^;]*)", facts) for facts in text.split("\n")[2::3]]
    return [(path.rsplit(".", 1)[-1], unit[1]) for path, unit in zip(text.split("\n")[::3], found) if unit]


def _with_unit(allowed, unit):
    """The unit stands behind the numbers: before what may stand in their place."""
    if not unit:
        return allowed
    numbers, rest = re.match(r"(.*?)((?:, or | with kind).*|)$", allowed).groups()
    return f"{numbers} {'in ' if numbers.endswith('a number') else ''}{unit}{rest}"


def _facts(line):
    """Allowed values with their unit, and the default or `required`, with the version where it is not the first."""
    allowed, unit, fallback, since = "", "", "", ""
    for i, part in enumerate(line.split("; ")):
        if i == 0:
            allowed = part
        elif part.startswith("in "):
            unit = part[3:]
        elif part.startswith("since "):
            since = f" ({part})"
        else:
            fallback = part[len("default "):] if part.startswith("default ") else part
    return _with_unit(allowed, unit), (fallback + since).strip()


def sections_of(text):
    """Rows by the sections of a configuration; a key of no section is one alone."""
    sections = {}
    for path, *said in rows(text):
        sections.setdefault(path.split(".")[0], []).append((path, *said))
    return sections


def table_of(listed):
    """A table of such rows in Markdown."""
    return _HEAD + "".join(map(_row, listed))


def _row(said):
    path, *rest = said
    return f"| `{path}` | " + " | ".join(word.replace("|", "\\|") for word in rest) + " |\n"

