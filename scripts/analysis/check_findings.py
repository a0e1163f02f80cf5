"""The program behind check_findings.sh, which says what it does."""

import argparse
import os
import subprocess
import sys
import textwrap

import findings_annulus
import findings_both_sides
import findings_one_side
from command import run_program
from finding import HOLDS, NO_MAP, NOT_REPRODUCED, PARTLY
from rubplot.failure import Failure
from studied_machine import ROLES, StudiedMachine

FINDINGS = findings_one_side.FINDINGS + findings_both_sides.FINDINGS + findings_annulus.FINDINGS
TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# The machines in configs/, by name: a configuration for every role that they have a map of.
SHIPPED = {
    "reference": {
        "one_side": "reference/figure06_one_side",
        "both_sides": "reference/figure09_both_sides",
        "both_sides_unequal": "reference/both_sides_unequal",
        "annulus": "reference/figure11_annulus",
        "annulus_offset": "reference/figure12_annulus_offset",
    },
    "sets A, D": {
        "one_side": "benchmark/one_side",
        "both_sides": "benchmark/both_sides",
        "both_sides_unequal": "benchmark/both_sides_unequal",
        "annulus": "benchmark/annulus",
        "annulus_offset": "benchmark/annulus_offset",
    },
    "set B": {
        "one_side": "hard_case/one_side",
        "both_sides": "hard_case/both_sides",
        "both_sides_unequal": "hard_case/both_sides_unequal",
        "annulus": "hard_case/annulus",
        "annulus_offset": "hard_case/annulus_offset",
    },
}
WIDTH = 120


def shipped_directories(stems, maps, rubsweep):
    """The directories of a shipped machine's maps; computes those that are not there."""
    directories = {}
    for role, stem in stems.items():
        directory = os.path.join(maps, stem)
        if not os.path.exists(os.path.join(directory, "map.csv")):
            command = [rubsweep, os.path.join(TOP, "configs", stem + ".yaml"), "--output", directory, "--quiet"]
            if subprocess.run(command, check=False).returncode not in (0, 4):  # 4: done, but some cells failed
                raise Failure(f"rubsweep could not make {directory}")
        directories[role] = directory
    return directories


def own_directories(directory):
    """The directories of a machine of one's own: those of DIRECTORY/ROLE that hold a map."""
    found = {role: os.path.join(directory, role) for role in ROLES}
    found = {role: name for role, name in found.items() if os.path.exists(os.path.join(name, "map.csv"))}
    if not found:
        raise Failure(f"{directory} holds no map.csv in any of {', '.join(ROLES)}")
    return found


def table(machines):
    """The lines of the table."""
    verdicts = {machine.name: [] for machine in machines}
    for finding in FINDINGS:
        yield finding.title
        for name in ("paper", "counted", "threshold", "reason"):
            yield textwrap.fill(
                getattr(finding, name), WIDTH, initial_indent=f"   {name:<10} ", subsequent_indent=" " * 14
            )
        for machine in machines:
            outcome = finding.outcome(machine)
            verdicts[machine.name].append(outcome.verdict)
            yield result_line(machine.name, outcome)
        yield ""
    for name, found in verdicts.items():
        yield counts(name, found)


def counts(name, found):
    return f"{name}: " + ", ".join(f"{found.count(verdict)} {verdict}" for verdict in (HOLDS, PARTLY, NOT_REPRODUCED, NO_MAP))


def result_line(name, outcome):
    return f"   {name:<10} | {outcome.measured} | {outcome.verdict}"


def brief(machine):
    """A heading, then a line for each finding of one machine."""
    yield "# finding | number that decides | verdict"
    found = [finding.outcome(machine) for finding in FINDINGS]
    for finding, outcome in zip(FINDINGS, found):
        yield f"{finding.title} | {outcome.measured} | {outcome.verdict}"
    yield counts(machine.name, [outcome.verdict for outcome in found])


def read_verdicts(lines):
    """A dict from (title of the finding, name of the machine) to the verdict, from the lines of a table."""
    verdicts, title = {}, None
    for line in lines:
        cells = [cell.strip() for cell in line.split(" | ")]
        if len(cells) == 3:
            verdicts[title, cells[0]] = cells[2]
        elif line[:1].isdigit():
            title = line.strip()
    return verdicts


def differences(expected, found):
    """One line for each verdict that is another than expected, is not there, or was not expected."""
    for place in {**expected, **found}:
        before, now = expected.get(place, "no such row"), found.get(place, "no such row")
        if before != now:
            yield f"{place[0]}, {place[1]}: expected '{before}', found '{now}'"


def parse(arguments):
    parser = argparse.ArgumentParser(prog="check_findings.sh", add_help=False, allow_abbrev=False)
    parser.add_argument("--programs", default=os.path.join(TOP, "build/release/apps"))
    parser.add_argument("--maps", default=os.path.join(TOP, "results"))
    parser.add_argument("--machine", action="append", default=[], metavar="NAME=DIR")
    parser.add_argument("--expected")
    parser.add_argument("--brief", metavar="DIR")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    expected = None
    if options.expected:
        with open(options.expected, encoding="utf-8") as file:
            expected = read_verdicts(file)
        if not expected:
            raise Failure(f"{options.expected} holds no verdict")
    maps, programs = os.path.abspath(options.maps), os.path.abspath(options.programs)
    rubtrace = os.path.join(programs, "rubtrace")
    if options.brief:
        found = own_directories(os.path.abspath(options.brief))
        print("\n".join(brief(StudiedMachine("brief", found, rubtrace))))
        return
    directories = {
        name: shipped_directories(stems, maps, os.path.join(programs, "rubsweep")) for name, stems in SHIPPED.items()
    }
    for machine in options.machine:
        name, separator, directory = machine.partition("=")
        if not separator or not name or name in directories or " | " in name:
            raise Failure(f"--machine {machine}: allowed: NAME=DIR with a name of its own")
        directories[name] = own_directories(os.path.abspath(directory))
    lines = []
    for line in table([StudiedMachine(name, found, rubtrace) for name, found in directories.items()]):
        print(line, flush=True)
        lines.append(line)
    if expected is not None:
        changed = list(differences(expected, read_verdicts(lines)))
        for line in changed:
            print(f"check_findings.sh: {line}", file=sys.stderr)
        if changed:
            sys.exit(1)


if __name__ == "__main__":
    run_program(main, usage="check_findings.sh [--programs DIR] [--maps DIR] [--machine NAME=DIR]... [--expected FILE] | --brief DIR")
