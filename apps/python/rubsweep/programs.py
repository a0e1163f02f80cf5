"""The programs, found and run."""

import json
import os
import shutil
import signal
import subprocess
import sys
from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional, Sequence

from .errors import BadInput, RubsweepError

USAGE, BAD_INPUT, SOME_CELLS_FAILED = 1, 2, 4
WITH_PROGRESS = {"rubsweep", "rubline", "rubbasin", "rubdiagnose"}


@dataclass
class Answer:
    """Text printed by a program, and the JSON line that `--summary json` prints at its end."""

    text: str
    summary: Dict[str, Any] = field(default_factory=dict)


def find(program: str) -> str:
    """The path of a program: in the directory of RUBSWEEP_PROGRAMS, else on the PATH. Throws RubsweepError where there
    is none."""
    directory = os.environ.get("RUBSWEEP_PROGRAMS")
    path = shutil.which(program, path=directory) if directory else shutil.which(program)
    if path is None:
        where = f"in {directory} (RUBSWEEP_PROGRAMS)" if directory else "on the PATH"
        raise RubsweepError([f"there is no program {program} {where}"], 127)
    return path


def call(program: str, arguments: Sequence[str], progress: Optional[bool] = None) -> Answer:
    """Runs a program to its end. `progress`: show its progress on standard error; None: where that is a terminal. An
    interrupt reaches the program, which keeps what it has, and is raised again when it has ended. Throws BadInput or
    RubsweepError; cells that failed are rows of the answer and no error."""
    shown = sys.stderr.isatty() if progress is None else progress
    command = [find(program), *arguments, "--summary", "json"]
    if program in WITH_PROGRESS:
        command += ["--progress", "always" if shown else "never"]
    # In its own session the program gets an interrupt of the terminal only once, from this process.
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=None if shown else subprocess.PIPE, text=True, encoding="utf-8",
                               errors="replace", start_new_session=True)
    try:
        out, err = process.communicate()
    except BaseException:
        process.send_signal(signal.SIGINT)
        process.communicate()
        raise
    return answer_of(process.returncode, out, err or "")


def answer_of(code: int, out: str, err: str) -> Answer:
    """The answer of a program that ended with `code`; raises the exception for its fault otherwise."""
    text, summary = split_summary(out)
    if code in (0, SOME_CELLS_FAILED):
        return Answer(text, summary)
    messages: List[str] = list(summary.get("messages", [])) or [line for line in err.splitlines() if line.strip()]
    raise (BadInput if code in (USAGE, BAD_INPUT) else RubsweepError)(messages, code)


def split_summary(out: str) -> "tuple[str, Dict[str, Any]]":
    """The text that was printed, and the JSON of its last line."""
    head, _, last = out.rstrip("\n").rpartition("\n")
    try:
        summary = json.loads(last)
    except ValueError:
        return out, {}
    return (head + "\n" if head else "", summary) if isinstance(summary, dict) else (out, {})
