"""The program behind insert_tables.sh, which says what it does."""

import argparse
import os
import re
import subprocess
import sys

from rubplot.failure import Failure

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MADE = re.compile(r"^<!-- Made by (?P<command>(?s:.*?)),\n     commit .*, on .* -->\n(?P<table>(?s:.*?))"
                  r"^<!-- End of what is made\. -->$", re.MULTILINE)


def printed(command):
    """Output of a command, run in the top folder."""
    one_line = " ".join(command.split("\n     "))
    done = subprocess.run(["bash", "-o", "pipefail", "-c", one_line], cwd=TOP, capture_output=True, text=True, check=False)
    if done.returncode != 0 or not done.stdout.startswith("|"):
        raise Failure(f"{command} ends with {done.returncode} and prints no table: {done.stderr.strip()}")
    return done.stdout


def with_tables(text, make, only, commit, machine):
    """The text with the tables that `make` prints for their commands, where these contain `only`."""
    def anew(match):
        command = match["command"]
        if only not in command:
            return match[0]
        return f"<!-- Made by {command},\n     commit {commit}, on {machine} -->\n{make(command)}<!-- End of what is made. -->"
    return MADE.sub(anew, text)


def stale_tables(text, make, only):
    """Commands of tables that differ from what `make` prints for them now."""
    return [match["command"] for match in MADE.finditer(text)
            if only in match["command"] and make(match["command"]) != match["table"]]


def this_commit():
    return subprocess.run(["git", "-C", TOP, "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True).stdout.strip()


def this_machine():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = re.findall(r"^model name\s*:\s*(.*)", file.read(), re.MULTILINE)
    return f"{len(names)} x {' '.join(names[0].split())}" if names else "a machine of unknown name"


def main(arguments):
    parser = argparse.ArgumentParser(prog="insert_tables.sh")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--only", default="", metavar="TEXT")
    parser.add_argument("documents", nargs="+", metavar="DOCUMENT")
    options = parser.parse_args(arguments)
    stale = False
    for path in options.documents:
        with open(path, encoding="utf-8") as file:
            text = file.read()
        if options.check:
            for command in stale_tables(text, printed, options.only):
                print(f"{path}: the table of {command} is not what it prints now")
                stale = True
            continue
        changed = with_tables(text, printed, options.only, this_commit(), this_machine())
        if changed != text:
            with open(path, "w", encoding="utf-8") as file:
                file.write(changed)
    return 1 if stale else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Failure as failure:
        print(f"insert_tables.sh: {failure}", file=sys.stderr)
        sys.exit(2)
