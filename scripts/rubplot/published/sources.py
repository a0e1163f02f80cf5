"""The sources of rubsweep and the programs built of them, which compute what the published figures show."""

import os
import subprocess
from dataclasses import dataclass
from typing import Optional, Tuple

from rubplot import subcommand
from rubplot.failure import Failure
from rubplot.output import DEFAULT_FORMATS, targets

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
DONE, SOME_CELLS_FAILED = 0, 4


@dataclass(frozen=True)
class Sources:
    """Directories of the configurations, the programs, and what they write."""

    configs: str = os.path.join(TOP, "configs")
    programs: str = os.path.join(TOP, "build", "release", "apps")
    results: str = os.path.join(TOP, "results")

    def config(self, stem):
        folder, name = ("ring", stem.removeprefix("ring_")) if stem.startswith("ring_") else ("", stem)
        path = os.path.join(self.configs, folder, name + ".yaml")
        if not os.path.exists(path):
            raise Failure(f"there is no {path}: published figures need the sources of rubsweep, or --configs DIR")
        return path

    def command(self, program, stem, *arguments):
        """Command that runs a program on one of the configurations."""
        path = os.path.join(self.programs, program)
        if not os.access(path, os.X_OK):
            raise Failure(f"there is no {path}: scripts/test.sh builds it, or say --programs DIR")
        return [path, self.config(stem), *arguments]

    def run(self, program, stem, *arguments):
        command = self.command(program, stem, *arguments)
        code = subprocess.run(command, check=False).returncode
        # A map shows which of its cells failed.
        if code not in (DONE, SOME_CELLS_FAILED):
            raise Failure(f"{program} ended with {code}: {' '.join(command)}")

    def figure(self, name):
        """Where a picture goes unless the user says it."""
        return os.path.join(self.results, "figures", name)


@dataclass(frozen=True)
class Wanted:
    """Choices of the user for a figure: its file, its formats and a map that is there already, each None where not said."""

    output: Optional[str] = None
    formats: Optional[Tuple[str, ...]] = None
    map: Optional[str] = None

    def draw(self, picture, basename, formats=DEFAULT_FORMATS):
        """Draws a picture where the user wants it, else as BASENAME in these formats."""
        chosen = self.formats if self.output or self.formats else formats
        subcommand.draw_picture(picture, targets(self.output or basename, chosen))
