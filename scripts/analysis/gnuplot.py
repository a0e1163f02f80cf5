"""Runs the gnuplot scripts of the folder above."""

import os
import subprocess
import tempfile

from command import Failure

SCRIPTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def draw(script, *arguments):
    """gnuplot -c SCRIPT ARGUMENT..., without what ~/.gnuplot says; names of files must be absolute, to gnuplot others may
    be commands."""
    if subprocess.run(["gnuplot", "-d", "-c", os.path.join(SCRIPTS, script), *arguments], check=False).returncode:
        raise Failure(f"gnuplot failed in {script}")


def draw_files(script, files, output, *arguments):
    """gnuplot -c SCRIPT WORK OUTPUT ARGUMENT..., WORK being a directory with `files`, a dict from name to lines, and
    OUTPUT an absolute name whose directory is made."""
    with tempfile.TemporaryDirectory() as work:
        for name, lines in files.items():
            with open(os.path.join(work, name), "w", encoding="utf-8") as file:
                file.writelines(line + "\n" for line in lines)
        os.makedirs(os.path.dirname(output), exist_ok=True)
        draw(script, work, output, *arguments)
