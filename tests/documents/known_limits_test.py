"""known_limits_test.py TOP PROGRAMS: every command of docs/known-limits.md says what the page promises (see dialogue.py)."""

import os
import sys
import tempfile

from dialogue import blocks, environment_of, is_dialogue, wrong_answers


def main(top, programs):
    with open(os.path.join(top, "docs", "known-limits.md"), encoding="utf-8") as file:
        dialogues = [block for _, block in blocks(file.read()) if is_dialogue(block)]
    wrong = [] if len(dialogues) >= 10 else [f"{len(dialogues)} dialogues, expected 10 or more"]
    with tempfile.TemporaryDirectory() as work:
        os.symlink(os.path.join(top, "configs"), os.path.join(work, "configs"))
        for block in dialogues:
            wrong += wrong_answers(block, work, environment_of(programs))
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
