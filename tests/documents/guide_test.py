"""guide_test.py TOP PROGRAMS: every page of docs/guide holds what it promises.

Its files and dialogues are those of dialogue.py, held in an empty directory for each page, with the shipped configurations
and scripts in it. A block behind "(not run here):" is only shown. A page has at most 1800 words, its time of reading below
the title, a picture, and a link from docs/user-guide.md. Exits with 77 where there is no gnuplot. RUBSWEEP_GUIDE names a page,
to run it alone."""

import concurrent.futures
import glob
import os
import re
import shutil
import sys
import tempfile

from dialogue import environment_of, wrong_blocks

MOST_WORDS = 1800
WORDS_PER_MINUTE = 200
# Blocks of all pages that need an administrator, a compiler or minutes.
MOST_BLOCKS_NOT_RUN = 6


def wrong_form(path, text):
    """Faults of a page that need no program."""
    words = len(text.split())
    if words > MOST_WORDS:
        yield f"{words} words, allowed: {MOST_WORDS}"
    minutes = re.match(r"# [^\n]+\n\n\*(\d+) minutes\.\*", text)
    if not minutes or abs(int(minutes[1]) - words / WORDS_PER_MINUTE) > 1:
        yield f"the line below the title does not say *{max(2, round(words / WORDS_PER_MINUTE))} minutes.*"
    pictures = re.findall(r"!\[[^\]]+\]\(([^)]+)\)", text)
    if not pictures:
        yield "no picture"
    for picture in pictures:
        if not os.path.isfile(os.path.join(os.path.dirname(path), picture)):
            yield f"there is no {picture}"


def wrong_page(top, path, environment):
    """Faults of a page, each with its name, and how many of its blocks are not run."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    name = os.path.basename(path)
    with tempfile.TemporaryDirectory() as work:
        for folder in ("configs", "scripts"):
            os.symlink(os.path.join(top, folder), os.path.join(work, folder))
        faults = [*wrong_form(path, text), *wrong_blocks(text, work, environment)]
    return [f"{name}: {fault}" for fault in faults], len(re.findall(r"\(not run here\):\n", text))


def main(top, programs):
    if not shutil.which("gnuplot"):
        print("skipped: there is no gnuplot")
        return 77
    pages = sorted(glob.glob(os.path.join(top, "docs", "guide", os.environ.get("RUBSWEEP_GUIDE", "*") + ".md")))
    with open(os.path.join(top, "docs", "user-guide.md"), encoding="utf-8") as file:
        linked = set(re.findall(r"\]\((guide/[^)#]+)", file.read()))
    environment = environment_of(programs)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        found = list(pool.map(lambda path: wrong_page(top, path, environment), pages))
    wrong = [fault for faults, _ in found for fault in faults]
    wrong += [f"{path}: no link from docs/user-guide.md" for path in pages
              if f"guide/{os.path.basename(path)}" not in linked]
    if sum(count for _, count in found) > MOST_BLOCKS_NOT_RUN:
        wrong.append(f"more than {MOST_BLOCKS_NOT_RUN} blocks are not run")
    if not pages:
        wrong.append("no pages")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
