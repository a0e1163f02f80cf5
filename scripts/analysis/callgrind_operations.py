"""Counts what a program does per turn from two callgrind profiles of it, one of more turns. Behind count_operations.sh.

callgrind_operations.py INSTRUCTIONS FEW FUNCTIONS_FEW MANY FUNCTIONS_MANY TURNS: INSTRUCTIONS has a line "ADDRESS
MNEMONIC" for each instruction of the program, FEW and MANY are profiles by instruction, FUNCTIONS_* what
callgrind_annotate makes of them, TURNS how many turns MANY has more.
"""

import re

from command import run_program

PROGRAM = "exact_turns"
OPERATIONS = {
    "multiplications": re.compile(r"mul[ps]d"),
    "additions": re.compile(r"(add|sub)[ps]d"),
    "divisions": re.compile(r"div[ps]d"),
    "square roots": re.compile(r"sqrt[ps]d"),
}
PARTS = {
    "inside": "ExactRun<4>::go_on(",
    "landings": "ExactMotion<4>::land(",
    "switches": "ExactRun<4>::switch_mode(",
}


def count_profile(lines, mnemonics):
    """Instructions and operations of one profile. Packed instructions do two operations; those of other objects than
    the program, libm among them, count as instructions only."""
    counts = dict.fromkeys(("instructions", *OPERATIONS), 0)
    own = repeats = False
    for line in lines:
        if line.startswith("ob="):
            own = line.rstrip().endswith(PROGRAM)
        elif line.startswith("calls="):
            repeats = True  # the line after it repeats what the function called has taken
        elif line.startswith("0x"):
            if repeats:
                repeats = False
                continue
            address, _, cost = line.split()[:3]
            counts["instructions"] += int(cost)
            mnemonic = mnemonics.get(address, "") if own else ""
            for name, pattern in OPERATIONS.items():
                if pattern.fullmatch(mnemonic):
                    counts[name] += int(cost) * (2 if mnemonic.endswith("pd") else 1)
    return counts


def count_parts(lines):
    """Instructions of the functions that PARTS names, with those of what they call."""
    counts = dict.fromkeys(PARTS, 0)
    for line in lines:
        for name, function in PARTS.items():
            if function in line:
                counts[name] += int(line.split()[0].replace(",", ""))
    return counts


def per_turn(few, many, turns):
    return {name: (many[name] - few[name]) / turns for name in many}


def main(arguments):
    instructions, few, functions_few, many, functions_many, turns = arguments
    mnemonics = dict(line.split() for line in _lines(instructions) if len(line.split()) == 2)
    counts = per_turn(*(count_profile(_lines(path), mnemonics) for path in (few, many)), int(turns))
    print("per turn: " + ", ".join("%.0f %s" % (count, name) for name, count in counts.items()))
    parts = per_turn(*(count_parts(_lines(path)) for path in (functions_few, functions_many)), int(turns))
    steps = parts["inside"] - parts["landings"] - parts["switches"]
    print("of the instructions: %.0f in steps, %.0f in landings, %.0f in switches" % (steps, parts["landings"], parts["switches"]))


def _lines(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        yield from file


if __name__ == "__main__":
    run_program(main, usage="callgrind_operations.py INSTRUCTIONS FEW FUNCTIONS_FEW MANY FUNCTIONS_MANY TURNS", least=6, most=6)
