"""Words that can be completed on the command line of a program."""

from dataclasses import dataclass, field
from typing import Dict, Tuple


@dataclass(frozen=True)
class Word:
    """An option. `kind` says what stands behind it: nothing (""), "folder", "file", "key" (of a configuration),
    "setting" (such a key and =), "word" (one of `words`) or "text"."""

    name: str
    kind: str
    words: Tuple[str, ...]
    meaning: str


@dataclass(frozen=True)
class Completed:
    """`source` is what stands on the command line without an option: "configuration", "folder", "table" or "file".
    `pictures` are subcommands with options of their own; `summaries` say what each is."""

    name: str
    source: str
    options: Tuple[Word, ...]
    pictures: Dict[str, Tuple[Word, ...]] = field(default_factory=dict)
    summaries: Dict[str, str] = field(default_factory=dict)


def asked_for_keys(name):
    """The program that knows the keys of the configurations that the program `name` reads."""
    return "ringstab" if name == "ringstab" else "rubsweep"


ENDINGS = {"configuration": "yaml", "table": "csv"}  # of the files that are meant
