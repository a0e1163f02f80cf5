"""Runs the gnuplot scripts of the folder above."""

import os
import subprocess

from command import Failure

SCRIPTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def draw(script, *arguments):
    """gnuplot -c SCRIPT ARGUMENT...; names of files must be absolute, to gnuplot others may be commands."""
    if subprocess.run(["gnuplot", "-c", os.path.join(SCRIPTS, script), *arguments], check=False).returncode:
        raise Failure(f"gnuplot failed in {script}")
