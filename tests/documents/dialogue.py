"""Dialogues of the documents: indented blocks of commands behind `$ ` and of what each of them prints, where a line of
`...` stands for any lines, and `...` in a line for anything. A command succeeds unless `exit code N` is its last line."""

import os
import re
import subprocess


def environment_of(programs):
    """The environment of somebody who reads English, with a directory of programs before all others."""
    return {**os.environ, "PATH": os.pathsep.join([programs, os.environ["PATH"]]), "LC_ALL": "C"}


def is_dialogue(block):
    return block[0].startswith("$ ")


def blocks(text):
    """The indented blocks of a text, each behind the last line before it."""
    before, block = "", []
    for line in text.splitlines() + ["end"]:
        if line.startswith("    "):
            block.append(line[4:])
        elif line:
            if block:
                yield before, block
            before, block = line, []


def dialogue(block):
    """Commands of a block with the lines that each should print."""
    parts = []
    continues = False
    for line in block:
        if line.startswith("$ "):
            parts.append(([line[2:]], []))
        elif continues:
            parts[-1][0].append(line)
        else:
            parts[-1][1].append(line)
        continues = line.endswith("\\") and not parts[-1][1]
    return [("\n".join(command), expected) for command, expected in parts]


def pattern(expected):
    """A regular expression of the promised lines."""
    def of_line(line):
        return r"(.*\n)*?" if line == "..." else ".*".join(map(re.escape, line.split("..."))) + r"\n"

    return re.compile("".join(map(of_line, expected)))


def wrong_answers(block, work, environment):
    """Each answer of a dialogue that is not as promised, in words; nothing where all is well."""
    for command, expected in dialogue(block):
        status = int(expected.pop().split()[-1]) if expected and expected[-1].startswith("exit code ") else 0
        ran = subprocess.run(["bash", "-c", command], cwd=work, env=environment, text=True, stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if ran.returncode != status:
            yield f"$ {command}\nexit code {ran.returncode}\n{ran.stdout}"
        elif not pattern(expected).fullmatch(ran.stdout):
            yield f"$ {command}\nprinted:\n{ran.stdout}promised:\n" + "\n".join(expected)


def wrong_blocks(text, work, environment):
    """Everything in the blocks of a text that is not as promised: the block behind "Save this as `NAME`:" becomes that
    file in the directory `work`, one behind "(not run here):" is only shown, any other is a dialogue that is held there."""
    for before, block in blocks(text):
        if before.endswith("(not run here):"):
            continue
        if name := re.search(r"Save this as `([^`]+)`:$", before):
            with open(os.path.join(work, name[1]), "w", encoding="utf-8") as file:
                file.write("\n".join(block) + "\n")
        elif is_dialogue(block):
            yield from wrong_answers(block, work, environment)
        else:
            yield f"a block that is neither file nor dialogue: {block[0]}"
