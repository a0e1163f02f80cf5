"""man_page.py NAME VERSION PROGRAM OTHERS OUTPUT: the manual page of a program, made of its --help.

OTHERS are the names of the programs that the page refers to, parted by commas. PROGRAM is the file of the program;
rubplot, whose pictures have a help each, is told by its name.
"""

import re
import sys

import help_text


def page(name, version, read, others):
    """Manual page of a help that was read."""
    purpose = _sentence(read.purpose)
    parts = [_head(name, version, purpose), ".SH SYNOPSIS"]
    for line in read.usage:
        parts += [".PP", _usage(line, name)]
    parts += [".SH DESCRIPTION", _escaped(read.purpose)]
    for lines in read.rest:
        parts += _paragraph(lines)
    parts.append(".SH OPTIONS")
    for option in read.options:
        parts += [".TP", _option_head(option), _escaped(option.meaning) or "\\&"]
    parts += [".SH EXAMPLES", *_as_written(read.examples)]
    parts += [".SH EXIT STATUS", *_exit_codes(read.exit_codes)]
    return "\n".join([*parts, *_see_also(name, others)])


def page_of_pictures(name, version, overview, pictures, others):
    """Manual page of rubplot: its own help, then that of each picture, as they are printed."""
    purpose = overview.split("\n\n")[1]
    parts = [_head(name, version, _sentence(purpose)), ".SH SYNOPSIS", *_as_written(overview.split("\n\n")[0].split("\n"))]
    parts += [".SH DESCRIPTION", *_as_written(overview.split("\n\n", 1)[1].split("\n"))]
    parts.append(".SH PICTURES")
    for picture, text in pictures.items():
        parts += [f".SS {_escaped(picture)}", *_as_written(text.rstrip("\n").split("\n"))]
    return "\n".join([*parts, *_see_also(name, others)])


def _head(name, version, purpose):
    return (f'.\\" Made of the help of the program.\n.TH {name.upper()} 1 "" "rubsweep {version}" "rubsweep"\n'
            f".SH NAME\n{_escaped(name)} \\- {_escaped(purpose)}")


def _see_also(name, others):
    listed = ", ".join(f"\\fB{_escaped(other)}\\fR(1)" for other in others if other != name)
    return [".SH SEE ALSO", listed, ".PP", "User guide and gallery: /usr/share/doc/rubsweep/docs/user\\-guide.md, gallery.md;",
            "configurations to begin with: /usr/share/doc/rubsweep/examples.", ""]


def _sentence(text):
    """The first sentence, without its end."""
    return re.split(r"[.?](?:\s|$)", text, maxsplit=1)[0].rstrip(".:")


def _escaped(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in text.split("\n"))


def _usage(line, name):
    before, _, behind = line.partition(name)
    return f"{_escaped(before)}\\fB{_escaped(name)}\\fR{_escaped(behind)}"


def _option_head(option):
    value = f" \\fI{_escaped(option.value)}\\fR" if option.value else ""
    default = f" {_escaped(option.default)}" if option.default else ""
    return f"\\fB{_escaped('--' + option.name)}\\fR{value}{default}"


def _as_written(lines):
    return [".nf", *(_escaped(line) if line else "\\&" for line in lines), ".fi"]


def _paragraph(lines):
    """A paragraph of prose and tables: rows of a table are two blanks, a name, and a meaning that goes on below itself.
    Where it has no row, lines with blanks before them are a file or commands, whose lines and blanks matter."""
    rows = [re.fullmatch(r"  (\S.*?)  +(\S.*)", line) for line in lines]
    parts = [".PP"]
    in_table = False
    for row, line in zip(rows, lines):
        if not any(rows) and line.startswith("  "):
            parts = parts[:-1] if parts[-1] == ".fi" else [*parts, ".nf"]
            parts += [_escaped(line), ".fi"]
        elif row:
            parts += [".TP", f"\\fI{_escaped(row[1])}\\fR", _escaped(row[2])]
            in_table = True
        elif in_table and not line.startswith("  "):
            parts += [".PP", _escaped(line)]
            in_table = False
        else:
            parts.append(_escaped(line.strip()))
    return parts


def _exit_codes(text):
    parts = []
    for one in re.split(r"; (?=\d)", text.rstrip(".")):
        code, _, meaning = one.partition(" ")
        parts += [".TP", f"\\fB{_escaped(code)}\\fR", _escaped(meaning)]
    return parts


def main(arguments):
    name, version, program, others, output = arguments
    others = others.split(",")
    if name == "rubplot":
        text = page_of_pictures(name, version, *help_text.help_of_pictures(program), others)
    else:
        text = page(name, version, help_text.help_of(program), others)
    with open(output, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main(sys.argv[1:])
