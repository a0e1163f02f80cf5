"""key_tables.py RUBSWEEP RINGSTAB DOCUMENT: writes the tables of keys behind the marker of docs/keys.md anew, as the programs
print them with --keys."""

import re
import subprocess
import sys

MARKER = "\n<!-- Made by packaging/key_tables.py; what follows is not written by hand. -->\n"
_HEAD = "| key | meaning | allowed | default |\n|---|---|---|---|\n"


def rows(text):
    """Path, meaning, and what is allowed and the default, of each key that --keys prints."""
    lines = text.split("\n")
    return [(lines[i], lines[i + 1].strip(), *_facts(lines[i + 2].strip())) for i in range(0, len(lines) - 2, 3)]


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


def tables(text):
    """A table for each section of a configuration; keys of no section come first."""
    sections = {}
    for path, *said in rows(text):
        sections.setdefault(path.split(".")[0], []).append((path, *said))
    alone = [section for section, listed in sections.items() if len(listed) == 1]
    parts = [_HEAD + "".join(_row(sections[section][0]) for section in alone)]
    parts += [f"### {section}\n\n{_HEAD}" + "".join(map(_row, listed))
              for section, listed in sections.items() if section not in alone]
    return "\n".join(parts)


def _row(said):
    path, *rest = said
    return f"| `{path}` | " + " | ".join(word.replace("|", "\\|") for word in rest) + " |\n"


def generated(rubsweep, ringstab):
    """All behind the marker, of the programs in these files."""
    ask = lambda program: subprocess.run([program, "--keys"], check=True, capture_output=True, text=True).stdout
    return f"{MARKER}\n## Keys of a rub configuration\n\n{tables(ask(rubsweep))}\n## Keys of the ring\n\n{tables(ask(ringstab))}"


def main(arguments):
    rubsweep, ringstab, document = arguments
    with open(document, encoding="utf-8") as file:
        head = file.read().split(MARKER)[0]
    with open(document, "w", encoding="utf-8") as file:
        file.write(head + generated(rubsweep, ringstab))


if __name__ == "__main__":
    main(sys.argv[1:])
