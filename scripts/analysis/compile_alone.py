"""The program behind compile_alone.sh, which says what it does."""

import concurrent.futures
import json
import os
import shlex
import subprocess
import sys
import time

from command import run_program


def commands_of(database, folders):
    """[(source, directory, command that makes no object)] of the sources that lie in these folders, not below them."""
    with open(os.path.join(database, "compile_commands.json"), encoding="utf-8") as stream:
        entries = json.load(stream)
    wanted = {os.path.realpath(folder) for folder in folders}
    found = {}
    for entry in entries:
        source = os.path.realpath(os.path.join(entry["directory"], entry["file"]))
        if os.path.dirname(source) not in wanted:
            continue
        words = shlex.split(entry["command"])
        words[words.index("-o") + 1] = os.devnull
        found.setdefault(source, (source, entry["directory"], words + ["-fsyntax-only"]))
    return list(found.values())


def compile_alone(command, deadline):
    """Words of the compiler about a source that it refuses; empty for a good one, None where the time is up."""
    _, directory, words = command
    if time.monotonic() >= deadline:
        return None
    done = subprocess.run(words, cwd=directory, capture_output=True, text=True, check=False)
    return "" if done.returncode == 0 else done.stderr or f"{' '.join(words)} ends with {done.returncode}\n"


def main(arguments):
    database, minutes, folders = arguments[0], float(arguments[1]), arguments[2:]
    commands = commands_of(database, folders)
    deadline = time.monotonic() + 60 * minutes
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
        said = list(threads.map(lambda command: compile_alone(command, deadline), commands))
    for text in filter(None, said):
        print(text, end="")
    refused, left_out = sum(map(bool, said)), said.count(None)
    if left_out:
        print(f"{left_out} of {len(said)} sources left out: the time is up")
    print(f"{len(said) - left_out} sources compiled alone, {refused} refused")
    sys.exit(1 if refused else 0)


if __name__ == "__main__":
    run_program(main, "compile_alone.sh [--minutes N] [FOLDER...]", 2)
