"""Messages of a program about bad input, as exceptions."""

import re
from dataclasses import dataclass
from typing import List, Optional

# Elements of a file of ROSS have a class, an underscore and a tag, in which blanks may stand.
PLACE = re.compile(r"(?:(?P<file>.+?):(?P<line>\d+):(?P<column>\d+): )?(?:--set [^:]+: )?"
                   r"(?:(?P<key>[A-Za-z_][\w.]*|(?:rotor\.file\.)?[A-Z][A-Za-z0-9]*_[^:]+): )?"
                   r"(?P<text>.*?)(?:, allowed: (?P<allowed>.*))?", re.DOTALL)


@dataclass(frozen=True)
class Problem:
    """One fault of the input. `file`, `line`, `column` and `key` are None where the program names none: a value that was
    overridden has a key and no line."""

    text: str
    file: Optional[str] = None
    line: Optional[int] = None
    column: Optional[int] = None
    key: Optional[str] = None
    allowed: Optional[str] = None


def problem_of(message: str) -> Problem:
    """Splits a message `file:line:column: path.to.key: text, allowed: ...` into its parts."""
    match = PLACE.fullmatch(message)
    if match is None:
        return Problem(message)
    line, column = match["line"], match["column"]
    return Problem(match["text"], match["file"], int(line) if line else None, int(column) if column else None,
                   match["key"], match["allowed"])


class RubsweepError(RuntimeError):
    """A program failed. `exit_code` and `messages` are those of the program."""

    def __init__(self, messages: List[str], exit_code: int) -> None:
        super().__init__("\n".join(messages) or f"exit code {exit_code}")
        self.messages = messages
        self.exit_code = exit_code


class BadInput(RubsweepError):
    """A configuration, recording or option that cannot be used. `problems` has all faults; `file`, `line`, `key`
    and `allowed` belong to the first one."""

    def __init__(self, messages: List[str], exit_code: int) -> None:
        super().__init__(messages, exit_code)
        self.problems = [problem_of(message) for message in messages]
        first = self.problems[0] if self.problems else Problem("")
        self.file, self.line, self.key, self.allowed = first.file, first.line, first.key, first.allowed
