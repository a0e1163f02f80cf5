"""What the command line knows of a picture, and how one is drawn."""

import argparse
import os
from dataclasses import dataclass
from typing import Callable, Optional, Tuple

from rubplot import gnuplot, output
from rubplot.gnuplot import Picture


def no_options(_):
    """For pictures that have none of their own."""


@dataclass(frozen=True)
class Subcommand:
    """`source` names what is drawn, `examples` stand behind `rubplot NAME` in the help. Has a `picture`, which makes one
    of the read arguments, or a `run` of its own."""

    name: str
    summary: str
    description: str
    source: str
    examples: Tuple[str, ...]
    heading: str = ""
    picture: Optional[Callable[[argparse.Namespace], Picture]] = None
    run: Optional[Callable[[argparse.Namespace], None]] = None
    options: Callable[[argparse.ArgumentParser], None] = no_options
    several_sources: bool = False


def draw(one, given):
    """Draws a picture as its arguments say; where they do not say whither, beside what it shows, and says where."""
    first = given.source[0] if one.several_sources else given.source
    beside = first if os.path.isdir(first) else os.path.dirname(first)
    formats = None if given.formats is None else output.read_formats(given.formats)
    files = output.targets(given.output or os.path.join(beside, one.name), formats)
    draw_picture(one.picture(given), files)
    if not given.output:
        for path in files.values():
            print(f"figure: {os.path.relpath(path)}")


def draw_picture(picture, files):
    """`files`: a dict from each format to the absolute name of its file."""
    with gnuplot.drawing(picture, tuple(files)) as drawn:
        for name, path in files.items():
            output.place(drawn[name], path)
