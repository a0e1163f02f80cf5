"""newcomers_test.py TOP: the way to each answer in docs/history/newcomers.md can be taken. Every page on it is linked from the
page before, beginning with README.md, by the words that the table shows; the heading is on the last page; and nobody needs
more than two clicks or five minutes."""

import os
import re
import sys

MOST_CLICKS, MOST_MINUTES, QUESTIONS = 2, 5, 12


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def flat(text):
    return " ".join(text.split())


def wrong_way(top, table, way):
    """Faults of a way, in words."""
    page = os.path.join(top, "README.md")
    clicks = re.findall(r"\[([^\]]+)\]\(([^)]+)\)", way)
    if not 1 <= len(clicks) <= MOST_CLICKS:
        yield f"{len(clicks)} clicks"
    for words, link in clicks:
        target = os.path.normpath(os.path.join(os.path.dirname(table), link))
        links = re.findall(r"\[([^\]]+)\]\(([^)#]+)(?:#[^)]*)?\)", flat(text_of(page)))
        if (words, target) not in [(said, os.path.normpath(os.path.join(os.path.dirname(page), to))) for said, to in links]:
            yield f"{os.path.relpath(page, top)} has no link '{words}' to {os.path.relpath(target, top)}"
        if not os.path.isfile(target):
            yield f"there is no {link}"
            return
        page = target
    heading = re.findall(r"\*([^*]+)\*", way)[-1]
    if heading not in re.findall(r"^#+ (.+)$", text_of(page), re.MULTILINE):
        yield f"{os.path.relpath(page, top)} has no heading '{heading}'"


def main(top):
    table = os.path.join(top, "docs", "history", "newcomers.md")
    rows = re.findall(r"^\| (?!who|-)[^|]+\| ([^|]+) \| ([^|]+) \| (\d+) \|$", text_of(table), re.MULTILINE)
    wrong = [f"{len(rows)} questions, expected {QUESTIONS}"] if len(rows) != QUESTIONS else []
    for question, way, minutes in rows:
        wrong += [f"{question}: {fault}" for fault in wrong_way(top, table, way)]
        if int(minutes) > MOST_MINUTES:
            wrong.append(f"{question}: {minutes} minutes")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
