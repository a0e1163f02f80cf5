"""Parts of what a program prints for --help: usage, purpose, options, examples, and the paragraphs between them."""

import re
import subprocess
from collections import Counter
from dataclasses import dataclass, field
from typing import List


@dataclass
class Option:
    """`value` is what the help calls its value, empty for one without; `default` the text behind it, "(=0)"."""

    name: str
    value: str
    default: str
    meaning: str


@dataclass
class Help:
    """`rest` holds the paragraphs behind the examples, each a list of lines, the exit codes apart."""

    usage: List[str] = field(default_factory=list)
    purpose: str = ""
    options: List[Option] = field(default_factory=list)
    examples: List[str] = field(default_factory=list)
    rest: List[List[str]] = field(default_factory=list)
    exit_codes: str = ""


def help_of(program):
    """The help of the program in this file. Raises CalledProcessError where it has none."""
    return parse(subprocess.run([program, "--help"], check=True, capture_output=True, text=True).stdout)


def pictures_of(overview):
    """Names of the pictures in the help of rubplot."""
    listed = overview.split("pictures:\n")[1].split("\n\n")[0]
    return [line.split()[0] for line in listed.split("\n")]


def help_of_pictures(program):
    """The overview of rubplot, the program in this file, and the help of each of its pictures by name."""
    ask = lambda *words: subprocess.run([program, *words], check=True, capture_output=True, text=True).stdout
    overview = ask("--help")
    return overview, {one: ask(one, "--help") for one in pictures_of(overview)}


def parse(text):
    """Parts of a help. Raises ValueError where one that every program has is missing."""
    read = Help()
    for lines in _paragraphs(text):
        if not read.usage:
            read.usage, read.purpose = _usage(lines)
        elif lines[0] == "Options:":
            read.options = options(lines[1:])
        elif lines[0] == "Examples:":
            read.examples = lines[1:]
        elif lines[0].startswith("Exit codes: "):
            read.exit_codes = " ".join(lines)[len("Exit codes: "):]
        else:
            read.rest.append(lines)
    for part in ("usage", "purpose", "options", "examples", "exit_codes"):
        if not getattr(read, part):
            raise ValueError(f"a help without its {part}: {text[:200]}")
    return read


def options(lines):
    """Options of the lines of a table whose meanings begin in one column and go on below there."""
    column = _column_of_meanings(lines)
    read = []
    for line in lines:
        if line[2:4] != "--":
            read[-1].meaning += " " + line.strip()
            continue
        # A head that is too wide for its column is followed by a single blank.
        head, meaning = line[:column].rstrip(), line[column:]
        match = re.fullmatch(r"  --([\w-]+) ?(\S*?)(?: ?\((=.*)\))?", head)
        if not match:
            raise ValueError(f"no option: {line}")
        read.append(Option(match[1], match[2], f"({match[3]})" if match[3] else "", meaning.strip()))
    return read


def _column_of_meanings(lines):
    starts = Counter()
    for line in lines:
        if line[2:4] == "--":
            starts.update(match.end() for match in [re.match(r"  --\S+(?: [^ ]\S*)*  +", line)] if match)
        else:
            starts.update([len(line) - len(line.lstrip())])
    if not starts:
        raise ValueError("a table of options without meanings")
    return starts.most_common(1)[0][0]


def _paragraphs(text):
    text = re.sub(r"\n+(?=Exit codes: )", "\n\n", text)  # a paragraph of their own, wherever they stand
    return [part.split("\n") for part in re.split(r"\n{2,}", text.strip("\n"))]


def _usage(lines):
    """Each usage, which ends with "[options]", and the sentence behind them."""
    text = " ".join(line.strip() for line in lines)
    usages, _, purpose = text.rpartition("[options]")
    return [f"{usage.strip()} [options]" for usage in usages.split("[options]") if usage.strip()], purpose.strip()
