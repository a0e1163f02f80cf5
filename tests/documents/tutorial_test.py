"""tutorial_test.py TOP PROGRAMS: runs the lessons of docs/tutorial.md, one after the other, in one empty directory.

Files and dialogues are those of dialogue.py. The picture of a lesson must be there behind it. Exits with 77 where there
is no gnuplot. RUBSWEEP_TUTORIAL names a directory that keeps the pictures."""

import os
import re
import shutil
import sys
import tempfile

from dialogue import environment_of, wrong_blocks


def wrong_lesson(text, work, environment):
    """Faults of a lesson; nothing where all is well."""
    yield from wrong_blocks(text, work, environment)
    pictures = re.findall(r"!\[[^\]]*\]\(tutorial/([^)]*)\)", text)
    if len(pictures) != 1:
        yield f"{text.splitlines()[0]}: {len(pictures)} pictures, expected one"
    for picture in pictures:
        path = os.path.join(work, picture)
        if not os.path.isfile(path) or os.path.getsize(path) < 2000:
            yield f"{text.splitlines()[0]}: no {picture}"


def main(top, programs):
    if not shutil.which("gnuplot"):
        print("skipped: there is no gnuplot")
        return 77
    with open(os.path.join(top, "docs", "tutorial.md"), encoding="utf-8") as file:
        lessons = re.split(r"^## ", file.read(), flags=re.MULTILINE)[1:]
    environment = environment_of(programs)
    with tempfile.TemporaryDirectory() as work:
        os.symlink(os.path.join(top, "configs"), os.path.join(work, "configs"))
        wrong = [f"{len(lessons)} lessons, expected 6"] if len(lessons) != 6 else []
        for lesson in lessons:
            wrong += wrong_lesson(lesson, work, environment)
        if keep := os.environ.get("RUBSWEEP_TUTORIAL"):
            os.makedirs(keep, exist_ok=True)
            for name in os.listdir(work):
                if name.endswith(".png"):
                    shutil.copy(os.path.join(work, name), keep)
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
