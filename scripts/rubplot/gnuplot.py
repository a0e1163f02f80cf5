"""Pictures as gnuplot makes them: a template, the values of its arguments and the files that it reads."""

import os
import shutil
import subprocess
import tempfile
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Dict, Iterable, Tuple

from rubplot import gnuplot_text, motion_kinds
from rubplot.failure import Failure

TEMPLATES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "templates")


@dataclass(frozen=True)
class Picture:
    """`template` is a file of templates/, `shared` those that stand before it; it finds `arguments` as ARG1, ARG2 and so
    on, and the lines of each of the `files` under its name."""

    template: str
    arguments: Tuple[str, ...] = ()
    files: Dict[str, Iterable[str]] = field(default_factory=dict)
    shared: Tuple[str, ...] = ()


def draw(picture, formats, work):
    """Draws it into the empty directory `work`; returns a dict from each format to its file."""
    if shutil.which("gnuplot") is None:
        raise Failure("there is no program called gnuplot to draw with (Debian: gnuplot-nox)")
    for name, lines in picture.files.items():
        write_lines(os.path.join(work, name), lines)
    # One script, so that no name of a directory becomes a part of gnuplot's commands.
    script = os.path.join(work, picture.template)
    with open(script, "w", encoding="utf-8") as file:
        file.write(f'formats = "{" ".join(formats)}"\n')
        for name in ("canvas.gp", *picture.shared, picture.template):
            if name == "motion_kinds.gp":
                file.write(motion_kinds.gnuplot_arrays())
            with open(os.path.join(TEMPLATES, name), encoding="utf-8") as template:
                file.write(template.read())
    # The picture is the same whatever the user has set for gnuplot.
    command = ["gnuplot", "-d", "-c", picture.template, *picture.arguments]
    done = subprocess.run(command, cwd=work, env={**os.environ, "LC_ALL": "C.UTF-8"}, check=False)
    drawn = {name: os.path.join(work, f"picture.{name}") for name in formats}
    if done.returncode or not all(os.path.exists(path) for path in drawn.values()):
        raise Failure(f"gnuplot failed in {picture.template}")
    if "svg" in drawn:
        _make_xml(drawn["svg"])
    return drawn


def _make_xml(path):
    """Makes a picture of gnuplot's well formed, which writes texts with ]]> and characters that XML has not as they are."""
    with open(path, encoding="utf-8", errors="replace") as file:
        text = file.read()
    allowed = gnuplot_text.allowed_in_xml(text)
    if allowed != text:
        with open(path, "w", encoding="utf-8") as file:
            file.write(allowed)


@contextmanager
def drawing(picture, formats):
    """A context with the dict that draw returns; the files go when it ends."""
    with tempfile.TemporaryDirectory(prefix="rubplot-") as work:
        yield draw(picture, formats, work)


def write_lines(path, lines):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(line + "\n" for line in lines)
