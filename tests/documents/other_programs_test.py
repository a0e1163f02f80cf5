"""other_programs_test.py TOP PROGRAMS: runs docs/other-programs.md in an empty directory, section by section.

Files and dialogues are those of dialogue.py. A section is left out, and the test says so, where its program is not
installed; exits with 77 where none is."""

import os
import re
import shutil
import subprocess
import sys
import tempfile

from dialogue import environment_of, wrong_blocks

# Section -> the program that it needs, with modules of Python.
NEEDED = {"pandas": ("python3", "pandas"), "NumPy and xarray": ("python3", "xarray, pandas, numpy"), "R": ("Rscript", None),
          "MATLAB and Octave": ("octave-cli", None)}


def python_with(modules):
    """A Python that has these modules, the one of the system where another comes first; None without."""
    for path in (shutil.which("python3"), "/usr/bin/python3"):
        if path and subprocess.run([path, "-c", f"import {modules}"], capture_output=True).returncode == 0:
            return path
    return None


def found(program, modules):
    return python_with(modules) if modules else shutil.which(program)


def main(top, programs):
    with open(os.path.join(top, "docs", "other-programs.md"), encoding="utf-8") as file:
        sections = re.split(r"^## ", file.read(), flags=re.MULTILINE)[1:]
    titles = [section.splitlines()[0] for section in sections]
    if titles[1:] != list(NEEDED):
        print(f"sections {titles}, expected one of files and those of {list(NEEDED)}")
        return 1
    places = {title: found(*need) for title, need in NEEDED.items()}
    for title, place in places.items():
        if not place:
            print(f"skipped: {title}: {' with '.join(filter(None, NEEDED[title]))} is not installed")
    if not any(places.values()):
        return 77
    wrong = []
    with tempfile.TemporaryDirectory() as work, tempfile.TemporaryDirectory() as first:
        os.symlink(os.path.join(top, "configs"), os.path.join(work, "configs"))
        environment = environment_of(programs)
        environment["PATH"] = os.pathsep.join([first, environment["PATH"]])
        # Where somebody has no directory for it, Octave ends with an error on standard error.
        environment["OCTAVE_HISTFILE"] = os.path.join(first, "octave_history")
        wrong += wrong_blocks(sections[0], work, environment)
        for title, section in zip(titles[1:], sections[1:]):
            if not places[title]:
                continue
            python = os.path.join(first, "python3")
            if os.path.lexists(python):
                os.remove(python)
            if NEEDED[title][1]:
                os.symlink(places[title], python)
            wrong += wrong_blocks(section, work, environment)
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
