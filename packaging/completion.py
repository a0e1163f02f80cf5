"""completion.py OUTPUT NAME=PROGRAM...: completion of options and their values for bash, zsh and fish.

Writes OUTPUT/bash/rubsweep, OUTPUT/zsh/_rubsweep and OUTPUT/fish/NAME.fish, made of the help of each program; rubplot is
told by its name, and has the options of each picture behind it.
"""

import os
import re
import sys

import completion_bash
import completion_fish
import completion_zsh
import help_text
from completed import Completed, Word

# Values that are no files: words to choose from, by the option that takes them.
_WORDS = {"progress": ("auto", "always", "never"), "formats": ("png", "svg", "pdf"),
          "init": ("one_side", "both_sides", "annular", "rotor_kit", "ross")}
_FOLDERS = ("DIR",)
_FILES = ("FILE", "FILE.csv", "FILE.yaml", "CONFIG.yaml")
_KEYS = {"set": "setting", "along": "key", "curve": "key"}
# Programs that read no configuration of their own: what stands on their command line.
_SOURCES = {"rubreport": "folder", "rubsweep-compare": "table", "rubplot": "file", "rubscope": "file",
            "rubdiagnose": "file"}


def completed(name, read):
    """Completion of a program whose help was read."""
    return Completed(name, _SOURCES.get(name, "configuration"), tuple(_word(option) for option in read.options))


def completed_pictures(name, overview, texts):
    """Completion of rubplot: `texts` is the help of each picture of its `overview`."""
    pictures = {picture: tuple(_plot_options(text)) for picture, text in texts.items()}
    summaries = dict(re.findall(r"^  (\S+) +(.*)$", overview.split("pictures:\n")[1].split("\n\n")[0], re.M))
    return Completed(name, _SOURCES[name], (Word("help", "", (), "print this and exit"),), pictures, summaries)


def _word(option):
    name, value = option.name, option.value
    if name in _WORDS:
        return Word(name, "word", _WORDS[name], option.meaning)
    if name in _KEYS:
        return Word(name, _KEYS[name], (), option.meaning)
    return Word(name, _kind(value), (), option.meaning)


def _kind(value):
    """Kind of the value that the help calls by this name."""
    if value in _FOLDERS:
        return "folder"
    if value in _FILES:
        return "file"
    return "text" if value else ""


def _plot_options(text):
    """Options of a picture in the way of argparse: `  -o, --output FILE  meaning`, which goes on below."""
    for match in re.finditer(r"^  (?:-\w(?: \w+)?, )?--([\w-]+)(?: (?:([A-Z]+)|\{([^}]*)\}))?(?: {2,}(.*)|\n +(.*)|)$", text, re.M):
        name, value, choices = match[1], match[2] or "", match[3]
        meaning = (match[4] or match[5] or "").strip()
        if choices or name in _WORDS:
            yield Word(name, "word", tuple(choices.split(",")) if choices else _WORDS[name], meaning)
        else:
            yield Word(name, _kind(value), (), meaning)


def _read(name, program):
    if name != "rubplot":
        return completed(name, help_text.help_of(program))
    return completed_pictures(name, *help_text.help_of_pictures(program))


def main(arguments):
    output, *programs = arguments
    everything = [_read(*program.split("=", 1)) for program in programs]
    _write(os.path.join(output, "bash", "rubsweep"), completion_bash.script(everything))
    _write(os.path.join(output, "zsh", "_rubsweep"), completion_zsh.script(everything))
    for one in everything:
        _write(os.path.join(output, "fish", one.name + ".fish"), completion_fish.script(one))


def _write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main(sys.argv[1:])
