#!/usr/bin/env python3
"""document_words.py [TOP]: the documents of the tree with their words that were written by hand, the longest first, their sum
and the longest page. Exits 1, and says which, where one has more than is allowed.

Neither generated documents and parts (behind or between `<!-- Made by ... -->`), nor tables, code and pictures count, nor does
the list of changes: nobody reads it from end to end.
"""

import pathlib
import re
import sys

MOST_IN_ALL = 55_000
MOST_IN_A_PAGE = 2_500
MOST_IN_README = 900
MOST_IN_A_CHAPTER = 3_000  # of docs/method
WORDS_PER_MINUTE = 200

_MADE = re.compile(r"^<!-- Made by .*?(?:^<!-- End of what is made\. -->$|\Z)", re.MULTILINE | re.DOTALL)
_FENCE = re.compile(r"^(```|~~~).*?^\1\s*$", re.MULTILINE | re.DOTALL)


def documents(top):
    """Paths of all documents, in order."""
    top = pathlib.Path(top)
    return sorted(path for pattern in ("*.md", "docs/**/*.md", "results/*.md", "studies/*.md") for path in top.glob(pattern)
                  if path.name != "CHANGELOG.md" and path.relative_to(top).parts[:2] != ("docs", "library"))


def by_hand(text):
    """The text with blank lines in place of what is generated and of fenced code, so that lines keep their numbers."""
    blank = lambda match: "\n" * match[0].count("\n")
    return _FENCE.sub(blank, _MADE.sub(blank, text))


def prose(text):
    """Pairs of line and paragraph: items of lists are one each; headings, tables, code and comments are none."""
    found, start, lines, in_list = [], 0, [], False

    def finish():
        if lines:
            found.append((start, " ".join(lines)))
            lines.clear()

    for number, line in enumerate(text.split("\n") + [""], 1):
        item = re.match(r"\s*([-*]|\d+\.)\s", line)
        indented = line.startswith("    ") and not lines
        if not line.strip() or line.startswith(("#", "|", "<!--", "![")) or indented and not (item and in_list):
            finish()
            in_list = in_list and (not line.strip() or indented)
            continue
        if item:
            finish()
            in_list = True
        if not lines:
            start = number
        lines.append(line.strip() if not item else line[item.end():].strip())
    return found


def words(text):
    """The number of words by hand in a document: of its prose and its headings, a link counted by its text."""
    text = by_hand(text)
    parts = [paragraph for _, paragraph in prose(text)] + re.findall(r"^#+ +(.*)", text, flags=re.MULTILINE)
    plain = re.sub(r"\]\([^)]*\)", "]", "\n".join(parts))
    return sum(1 for word in plain.split() if re.search(r"\w", word))


def most_in(place):
    """The words that a document at this place may have."""
    if place == "README.md":
        return MOST_IN_README
    return MOST_IN_A_CHAPTER if place.startswith("docs/method/") else MOST_IN_A_PAGE


def main(top):
    counted = sorted(((words(path.read_text(encoding="utf-8")), path.relative_to(top).as_posix()) for path in documents(top)),
                     reverse=True)
    for number, place in counted:
        print(f"{number:6}  {max(1, round(number / WORDS_PER_MINUTE)):3} min  {place}")
    total = sum(number for number, _ in counted)
    print(f"{total:6}  in all, in {len(counted)} documents; the longest: {counted[0][1]} with {counted[0][0]}")
    wrong = [f"{place}: {number} words, allowed: {most_in(place)}" for number, place in counted if number > most_in(place)]
    wrong += [f"all documents: {total} words, allowed: {MOST_IN_ALL}"] * (total > MOST_IN_ALL)
    print("\n".join(wrong), end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent)))
