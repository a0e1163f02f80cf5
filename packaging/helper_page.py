"""helper_page.py DOCUMENT RUBPLOT PROGRAM...: writes what follows the marker of docs/for-helpers.md anew: a section for each
program, as its --help has it, and the numbers to ask for, as the first program's --keys has them."""

import os
import re
import subprocess
import sys
import textwrap

from help_text import help_of
from key_tables import rows

MARKER = "\n<!-- Made by packaging/helper_page.py; what follows is not written by hand. -->\n"

WIDTH = 120

# The numbers of a machine with one stop that decide its map and that nobody can guess from the others.
ASKED = ["rotor.mass_kg", "rotor.natural_frequency_hz", "rotor.damping_ratio", "stops.N.angle_deg", "stops.N.clearance_m",
         "stops.N.stiffness_n_per_m", "stops.N.restitution", "stops.N.contact_radius_m", "stops.N.friction.coefficient",
         "stops.N.casing.mass_kg", "stops.N.casing.stiffness_n_per_m", "kick.force_n", "kick.duration_s"]


def section(name, read):
    """The parts of a program's help that a helper needs: purpose, usage, an example, exit codes."""
    example = read.examples[0].strip()
    for line in read.examples[1:]:
        if not example.endswith("\\"):
            break
        example = example[:-1] + line.strip()
    codes = "\n".join(textwrap.fill(f"- {code}", WIDTH, subsequent_indent="  ") for code in exit_codes(read.exit_codes))
    return (f"### {name}\n\n{textwrap.fill(read.purpose, WIDTH)}\n\n" + "".join(wrapped(usage, "    ") for usage in read.usage)
            + f"\nFor example:\n\n{wrapped(example, '    ')}\nExit codes:\n\n{codes}\n")


def exit_codes(text):
    """Each code with its meaning: parts that begin with a number; what follows without one belongs to the part before."""
    parts = []
    for part in text.rstrip(".").split("; "):
        if parts and not re.match(r"\d", part):
            parts[-1] += "; " + part
        else:
            parts.append(part)
    return parts


def wrapped(text, indent):
    """A command in lines of at most WIDTH characters, each but the last with a backslash."""
    lines, line = [], indent
    for word in text.split(" "):
        if len(line) + len(word) > WIDTH - 3:
            lines.append(line.rstrip() + " \\")
            line = indent + "  "
        line += word + " "
    return "\n".join([*lines, line.rstrip()]) + "\n"


def numbers(keys):
    """A table of the numbers to ask for. Raises KeyError where one is no key any more."""
    said = {path: rest for path, *rest in rows(keys)}
    lines = [f"| `{path}` | {said[path][0]} | {said[path][1]} |".replace("`|`", "`\\|`") for path in ASKED]
    return "| key | meaning | allowed |\n|---|---|---|\n" + "\n".join(lines) + "\n"


def generated(rubplot, programs):
    """All behind the marker, of the programs in these files; the first one knows the keys."""
    ask = lambda *words: subprocess.run(words, check=True, capture_output=True, text=True).stdout
    parts = [section(os.path.basename(program), help_of(program)) for program in programs]
    pictures = "".join(f"    {line}\n" if line else "\n" for line in ask(rubplot, "--help").strip("\n").split("\n"))
    return (f"{MARKER}\n## Numbers to ask for\n\n{numbers(ask(programs[0], '--keys'))}"
            f"\n## Programs\n\n" + "\n".join(parts) + f"\n### rubplot\n\n{pictures}")


def main(arguments):
    document, rubplot, *programs = arguments
    with open(document, encoding="utf-8") as file:
        head = file.read().split(MARKER)[0]
    with open(document, "w", encoding="utf-8") as file:
        file.write(head + generated(rubplot, programs))


if __name__ == "__main__":
    main(sys.argv[1:])
