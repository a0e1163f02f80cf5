"""reference_pages.py DOCS RUBPLOT PROGRAM...: writes docs/reference anew, and what follows the marker of docs/keys.md: pages of what
the programs say of themselves with --help, --keys, --columns and --motion-kinds. The first program is rubsweep."""

import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import defaultdict

import help_text
import helper_page
import key_tables
from helper_page import exit_codes

# The smallest set of recordings, whose README.md says what their columns are.
SET = """\
{recordings: 1, recordings_per_machine: 1, candidates: [no_rub], split: {training: 1, validation: 0, test: 0},
 output: {directory: set}}
"""

MARKER = "<!-- Made by packaging/reference_pages.py of what the programs say; nothing here is written by hand. -->\n"


def ask(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def code(text):
    """The text as code in a cell of a table; a backslash would be shown in front of a bar."""
    return f"`{text}`".replace("|", "\\|")


def table(head, rows):
    lines = ["| " + " | ".join(row) + " |" for row in [head, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]]) + "\n"


def page(title, *parts):
    return f"# {title}\n\n{MARKER}\n" + "\n".join(part.rstrip("\n") + "\n" for part in parts if part)


def block(lines):
    return "".join(f"    {line}\n" if line else "\n" for line in lines)


def anchor(text):
    """The name by which a heading can be linked to."""
    return re.sub(r"[^\w -]", "", text.lower()).replace(" ", "-")


class Programs:
    """Texts of all programs, by their names."""

    def __init__(self, rubplot, files):
        self.rubplot = rubplot
        self.names = [os.path.basename(file) for file in files]
        self.helps = {name: help_text.help_of(file) for name, file in zip(self.names, files)}
        sweep, data = files[0], files[self.names.index("rubdata")]
        self.listed = [*csv.DictReader(ask(sweep, "--columns").splitlines()), *columns_of_a_set(data)]
        self.kinds = list(csv.DictReader(ask(sweep, "--motion-kinds").splitlines()))
        self.keys = ask(sweep, "--keys")
        # Units by the ends of names, the longest end first where one is that of another.
        self.units = {}
        for name, unit in [(row["column"], row["unit"]) for row in self.listed] + key_tables.units(self.keys):
            spoken = re.sub(r"[^a-z0-9]+", "_", unit.lower().replace("/", " per ")).strip("_")
            spoken = {"degrees": "deg", "1_per_min": "rpm", "1_per_s": "per_s", "n_m": "nm"}.get(spoken, spoken)
            if unit and name.endswith("_" + spoken):
                self.units["_" + spoken] = unit
        self.ring_keys = ask(files[self.names.index("ringstab")], "--keys")

    def columns(self, program, file):
        """Rows of columns and words of a table, the row of the file itself left out."""
        rows = [row for row in self.listed if (row["program"], row["file"]) == (program, file) and row["column"]]
        rows = [{**row, "unit": self.unit(row["column"])} if file == "labels.csv" else row for row in rows]
        return rows if file != "map.csv" or program != "rubsweep" else self._of_maps(rows)

    def _of_maps(self, worded):
        """Columns of map.csv, which --help lists, each followed by the words that are said of it."""
        rows = []
        for condition, listed in tables_of_help(self.helps["rubsweep"].rest):
            if condition.startswith("Columns"):
                when = re.search(r"(?:with|where) .*", condition.rstrip(":"))
                for name, meaning in listed:
                    end = f" ({when[0]})" if when and "empty where" not in condition else ""
                    rows.append({"column": name, "word": "", "unit": self.unit(name), "meaning": meaning + end})
                    rows += [row for row in worded if row["column"] == name and row["word"]]
                    if name == "class":
                        rows += [{"column": name, "word": word, "unit": "", "meaning": said} for word, said in self.classes()]
        return rows

    def unit(self, name):
        """The unit that the end of a name says, as in other tables and in keys."""
        for end in ("_" + "_".join(name.split("_")[i:]) for i in range(1, len(name.split("_")))):
            if end in self.units:
                return self.units[end]
        return ""

    def classes(self):
        """Pairs of class and meaning."""
        return next(rows for heading, rows in tables_of_help(self.helps["rubsweep"].rest) if heading == "Classes:")

    def tables_of(self, program):
        """Pairs of file and meaning of each table that a program writes."""
        return [(row["file"], row["meaning"]) for row in self.listed if row["program"] == program and not row["column"]]


def columns_of_a_set(rubdata):
    """Columns of the tables of rubdata, as --columns has those of the others, of the README.md of a set."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "study.yaml"), "w", encoding="utf-8") as file:
            file.write(SET)
        subprocess.run([os.path.abspath(rubdata), "study.yaml", "--quiet"], cwd=folder, check=True)
        with open(os.path.join(folder, "set/README.md"), encoding="utf-8") as file:
            text = file.read()
    rows = []
    for head, name, meaning in (("a recording | unit | meaning", "recordings", "one recording; in training, validation and test"),
                                ("labels.csv | meaning", "labels.csv", "one row for every recording")):
        rows.append({"program": "rubdata", "file": name, "column": "", "word": "", "unit": "", "meaning": meaning})
        for line in text.split(f"| column of {head} |")[1].split("\n\n")[0].split("\n")[2:]:
            column, *unit, said = (part.strip() for part in line.strip("|").split(" | "))
            rows.append({"program": "rubdata", "file": name, "column": column.strip("`"), "word": "", "unit": "".join(unit),
                         "meaning": said})
    return rows


def tables_of_help(paragraphs):
    """Pairs of heading and rows (name, meaning) of the tables in paragraphs of a help."""
    found = []
    for lines in paragraphs:
        for line in lines:
            row = re.fullmatch(r"  (\S.*?)  +(\S.*)", line)
            if line.startswith("    ") and found and found[-1][1]:
                name, meaning = found[-1][1][-1]
                found[-1][1][-1] = (name, f"{meaning} {line.strip()}")
            elif row and found:
                found[-1][1].append((row[1], row[2]))
            elif not line.startswith(" "):
                found.append((line, []))
    return [(heading, rows) for heading, rows in found if rows]


def paragraph(lines):
    """A paragraph of a help in Markdown: prose, tables of names and meanings, and what is laid out by blanks as code."""
    parts, prose, rows = [], [], []

    def finish():
        if rows:
            parts.append(table(["", ""], [(code(name), cell(meaning)) for name, meaning in rows]))
        if prose:
            parts.append("\n".join(wrapped(" ".join(prose))) + "\n")
        rows.clear()
        prose.clear()

    if not any(re.fullmatch(r"  (\S.*?)  +(\S.*)", line) for line in lines) and any(line.startswith("  ") for line in lines):
        first = next(i for i, line in enumerate(lines) if line.startswith("  "))
        return "\n".join(wrapped(cell(" ".join(lines[:first])))) + "\n\n" + block(line[2:] for line in lines[first:])
    for line in lines:
        row = re.fullmatch(r"  (\S.*?)  +(\S.*)", line)
        if row and not line.startswith("    "):
            if prose:
                finish()
            rows.append((row[1], row[2]))
        elif line.startswith("  ") and rows:
            rows[-1] = (rows[-1][0], f"{rows[-1][1]} {line.strip()}")
        else:
            if rows:
                finish()
            prose.append(cell(line.strip()))
    finish()
    return "\n".join(parts)


def wrapped(text, width=118):
    lines, line = [], ""
    for word in text.split():
        if line and len(line) + 1 + len(word) > width:
            lines.append(line)
            line = word
        else:
            line = f"{line} {word}".strip()
    # No line may begin a list, a heading or a quotation by chance.
    return [re.sub(r"^([-+*#>]|\d+[.)])(?= |$)", r"\\\1", one) for one in [*lines, line] if one]


def column_table(rows):
    return table(["column", "unit", "meaning"], [
        (f"– {code(row['word'])}" if row["word"] else code(row["column"]), row["unit"], cell(row["meaning"])) for row in rows])


def program_page(programs, name):
    read = programs.helps[name]
    options = table(["option", "meaning"], [
        (code(f"--{one.name}{' ' if one.value else ''}{one.value}"), cell(f"{one.meaning} {one.default}".strip()))
        for one in read.options])
    parts = [*wrapped(cell(read.purpose)), "", usages(read.usage), "## Options", "", options, "## Examples", "",
             block(line[2:] for line in read.examples), "## What else it says", ""]
    tables = []
    for file, meaning in programs.tables_of(name):
        rows = programs.columns(name, file)
        tables += [f"### {file}\n", "\n".join(wrapped(sentence(meaning))) + "\n", column_table(rows) if rows else ""]
    # Columns of a map stand in the table below.
    rest = [] if not read.rest else [paragraph(lines) for lines in read.rest if not lines[0].startswith("Columns of ")]
    text = "\n".join(parts if rest else parts[:-2])
    codes = table(["code", "meaning"], [code_and_meaning(one) for one in exit_codes(read.exit_codes)])
    return page(name, text, *rest, "## Exit codes\n", codes, *(["## Tables that it writes\n", *tables] if tables else []))


def usages(lines):
    """Usages as code; a long one goes on behind a backslash."""
    return "".join(helper_page.wrapped(line, "    ") for line in lines)


def sentence(text):
    return cell(text[0].upper() + text[1:] + ("" if text.endswith(".") else "."))


def code_and_meaning(text):
    number, _, meaning = text.partition(" ")
    return number, cell(meaning)


def rubplot_page(program):
    overview, pictures = help_text.help_of_pictures(program)
    parts = [block(overview.strip("\n").split("\n"))]
    for name, text in pictures.items():
        parts += [f"## {name}\n", block(text.strip("\n").split("\n"))]
    return page("rubplot", *parts)


def columns_page(programs):
    """Every column of every table by its name, with the tables that have it."""
    meanings = defaultdict(lambda: defaultdict(list))
    for name in programs.names:
        for file, _ in programs.tables_of(name):
            for row in programs.columns(name, file):
                if not row["word"]:
                    link = f"[{file} of {name}](programs/{name}.md#{anchor(file)})"
                    meanings[row["column"], row["unit"]][row["meaning"]].append(link)
    rows = [(code(name), unit, cell(meaning), ", ".join(places))
            for (name, unit), said in sorted(meanings.items(), key=lambda item: (item[0][0].lower(), item[0])) for meaning, places in said.items()]
    return page("Columns of all tables", "\n".join(wrapped(
        "Every column by its name. N and K stand for a number from 0, UNBALANCE for the unbalance as the map has it (`whirl_ratio` or "
        "`eccentricity_m`), PARAMETER for the name of the parameter.")) + "\n",
        table(["column", "unit", "meaning", "table"], rows))


def files_page(programs):
    rows = []
    for name in programs.names:
        known = dict(programs.tables_of(name))
        said = {}
        for heading, listed in tables_of_help(programs.helps[name].rest):
            if heading.startswith(("Writes", "With ")) and heading.endswith(":"):
                for names, meaning in listed:
                    for one in names.split(", "):
                        said.setdefault(one, meaning)
        for file in [*said, *(file for file in known if file not in said)]:
            shown = f"[{code(file)}](programs/{name}.md#{anchor(file)})" if file in known else code(file)
            rows.append((f"[{name}](programs/{name}.md)", shown, cell(said.get(file) or known[file])))
    return page("Files of all programs", table(["program", "file", "content"], rows))


def words_page(programs):
    """Classes, kinds, and the words of every column that has words."""
    parts = ["## Classes of motion\n", table(["class", "meaning"], [(code(name), cell(meaning)) for name, meaning in programs.classes()]),
             "## Kinds of motion\n", "Column `kind` of map.csv: what figures part the motions by.\n",
             table(["kind", "in words"], [(code(row["name"]), cell(row["label"])) for row in programs.kinds])]
    seen = {}
    for row in programs.listed:
        if row["word"]:
            seen.setdefault((row["program"], row["file"], row["column"]), []).append(row)
    for (program, file, column), rows in seen.items():
        parts += [f"## {column} of {file}, {program}\n", table(["word", "meaning"], [
            (", ".join(code(word) for word in row["word"].split(", ")), cell(row["meaning"])) for row in rows])]
    return page("Words in the tables", *parts)


def exit_codes_page(programs):
    by_code = defaultdict(lambda: defaultdict(list))
    for name in programs.names:
        for text in exit_codes(programs.helps[name].exit_codes):
            number, meaning = code_and_meaning(text)
            by_code[number][meaning].append(f"[{name}](programs/{name}.md#exit-codes)")
    order = sorted(by_code, key=lambda number: int(re.match(r"\d+", number)[0]))
    rows = [(number, meaning, "all" if len(names) == len(programs.names) else ", ".join(names))
            for number in order for meaning, names in by_code[number].items()]
    return page("Exit codes of all programs", table(["code", "meaning", "programs"], rows))


def index_page(programs):
    pages = [("[Keys](../keys.md)", "every key of a configuration: meaning, unit, range, default"),
             ("[Columns](columns.md)", "every column of every table: unit, meaning, who writes it"),
             ("[Files](files.md)", "every file that a program writes"),
             ("[Words](words.md)", "classes, kinds, `status`, `proof` and other words in tables"),
             ("[Exit codes](exit-codes.md)", "what each number means, by program")]
    links = [(f"[{name}](programs/{name}.md)", cell(programs.helps[name].purpose)) for name in programs.names]
    links.append(("[rubplot](programs/rubplot.md)", cell(ask(programs.rubplot, "--help").split("\n\n")[1].replace("\n", " "))))
    return page("Reference", "\n".join(wrapped(
        "What the programs say of themselves, in pages: each is made from `--help`, `--keys`, `--columns` and "
        "`--motion-kinds`, and a test compares it with them.")) + "\n", table(["page", "what it holds"], pages),
        "## Programs\n", table(["program", "what it does"], links))


def key_pages(programs):
    """Pages of keys by their places below docs/reference, and what follows the marker of docs/keys.md."""
    pages, listed = {}, []
    for of, text in (("a rub configuration", programs.keys), ("the ring", programs.ring_keys)):
        alone, index, parts = [], [], []
        for name, rows in key_tables.sections_of(text).items():
            if len(rows) == 1:
                alone += rows
                continue
            place = "keys/ring.md" if of == "the ring" else f"keys/{name}.md"
            index.append((f"[`{name}`](reference/{place}{'#' + name if of == 'the ring' else ''})", cell(rows[0][1]), str(len(rows))))
            parts += [f"## {name}\n", key_tables.table_of(rows)]
            pages[place] = page("Keys of the ring", *parts) if of == "the ring" else page(f"Keys of {name}", parts[-1])
        listed += [f"## Keys of {of}\n", key_tables.table_of(alone), table(["section", "meaning", "keys"], index)]
    return pages, key_tables.MARKER + "\n" + "\n".join(part.rstrip("\n") + "\n" for part in listed)


def generated(rubplot, files):
    """All pages by their places below docs/reference, and what follows the marker of docs/keys.md."""
    programs = Programs(rubplot, files)
    pages, keys = key_pages(programs)
    pages.update({"README.md": index_page(programs), "columns.md": columns_page(programs), "files.md": files_page(programs),
                  "words.md": words_page(programs), "exit-codes.md": exit_codes_page(programs)})
    pages.update({f"programs/{name}.md": program_page(programs, name) for name in programs.names})
    pages["programs/rubplot.md"] = rubplot_page(rubplot)
    return pages, keys


def main(arguments):
    docs, rubplot, *files = arguments
    pages, keys = generated(rubplot, files)
    reference = os.path.join(docs, "reference")
    shutil.rmtree(reference, ignore_errors=True)
    for place, text in pages.items():
        path = os.path.join(reference, place)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    path = os.path.join(docs, "keys.md")
    with open(path, encoding="utf-8") as file:
        head = file.read().split(key_tables.MARKER)[0]
    with open(path, "w", encoding="utf-8") as file:
        file.write(head + keys)


if __name__ == "__main__":
    main(sys.argv[1:])
