"""Reads config.yaml as the programs write it beside their results, which is what --print-config prints.

That file is the merged configuration with every default: block style, one value per line, and matrices in blocks of
lines. Nothing else is YAML here; files that people write are for the programs alone to read.
"""

import re

from rubplot.failure import open_regular


class ConfigurationError(Exception):
    """A file that no program wrote; the message names file and line."""


class Configuration(dict):
    """A dict from the path of every value to its text, of the file `path`."""

    def __init__(self, path):
        super().__init__()
        self.path = path

    def __missing__(self, key):
        raise ConfigurationError(f"{self.path}: there is no {key}")


_LINE = re.compile(r"(?P<indent> *)(?P<item>- )?(?P<key>[a-z0-9_]+):(?: (?P<value>.*))?")


def read_configuration(path):
    """The values of a file; items of lists are numbered: stops.0.casing.mass_kg -> '0.05'."""
    values = Configuration(path)
    block = None  # key and lines of a text in several lines, such as a matrix
    open_keys = []  # (column, key) from the outermost to the one of this line; a dash stands two columns before its key
    with open_regular(path, encoding="utf-8", errors="replace") as file:
        for line_number, line in enumerate(file, 1):
            line = line.rstrip("\r\n")
            if block is not None and line.startswith(" " * (open_keys[-1][0] + 2)):
                values[block] += line.strip() + "\n"
                continue
            block = None
            if not line or line.startswith("#"):
                continue
            match = _LINE.fullmatch(line)
            if not match:
                raise ConfigurationError(f"{path}:{line_number}: not as a program writes it")
            column = len(match["indent"])
            if match["item"]:
                _open_item(open_keys, column)
                column += 2
            _close_down_to(open_keys, column)
            open_keys.append((column, match["key"]))
            if match["value"]:
                path_of_key = ".".join(str(key) for _, key in open_keys)
                block = path_of_key if match["value"] == "|" else None
                values[path_of_key] = "" if block else match["value"]
    return values


def numbers(text):
    """The numbers of a list in one line: '[0, 2.5e-4]' -> [0.0, 0.00025]."""
    if not (text.startswith("[") and text.endswith("]")):
        raise ConfigurationError(f"'{text}' is no list")
    return [number(part) for part in text[1:-1].split(",")]


def axis(values, path):
    """The values of an axis of a sweep, in the unit of its key: they are listed, or placed between two ends."""
    if f"{path}.count" not in values:
        listed = values.get(f"{path}.values")
        return numbers(listed) if listed else []
    first, last = number(values[f"{path}.from"]), number(values[f"{path}.to"])
    intervals = int(values[f"{path}.count"]) - 1
    if values.get(f"{path}.scale") == "log":
        inner = [first * (last / first) ** (i / intervals) for i in range(1, intervals)]
    else:
        inner = [first + (last - first) * i / intervals for i in range(1, intervals)]
    return [first, *inner, last]


def text(value):
    """The text of a title, an author or a note: one word as it is, or in double quotes."""
    if not value.startswith('"'):
        return value
    meaning = {"n": "\n", '"': '"', "\\": "\\"}
    return re.sub(
        r"\\(x[0-9a-f]{2}|.)",
        lambda match: chr(int(match[1][1:], 16)) if match[1][0] == "x" else meaning[match[1]],
        value[1:-1],
    )


def quoted(meaning):
    """A line of text as `text` reads it."""
    return '"' + meaning.replace("\\", "\\\\").replace('"', '\\"') + '"'


def number(text):
    """The number that a value is."""
    try:
        return float(text)
    except ValueError:
        raise ConfigurationError(f"'{text}' is no number") from None


def stop_count(values):
    """How many stops the machine has."""
    count = 0
    while f"stops.{count}.kind" in values:
        count += 1
    return count


def _close_down_to(open_keys, column):
    while open_keys and open_keys[-1][0] >= column:
        open_keys.pop()


def _open_item(open_keys, column):
    """Leaves the number of the item that begins at `column` as the last of the open keys."""
    item_column = column + 0.5  # inside the list's own key, outside the keys of the item
    while open_keys and open_keys[-1][0] > item_column:
        open_keys.pop()
    if open_keys and open_keys[-1][0] == item_column:
        open_keys[-1] = (item_column, open_keys[-1][1] + 1)
    else:
        open_keys.append((item_column, 0))
