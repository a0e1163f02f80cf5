"""A picture as the command line knows it, and how one is drawn."""

import argparse
import os
from dataclasses import dataclass
from typing import Callable, Optional, Tuple

from rubplot import gnuplot, output, shown_units
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
    units: Tuple[str, ...] = ()  # those that may be asked for: "speed", "length", "peak_to_peak"


def draw(one, given):
    """Draws a picture as its arguments say; where they do not say whither, beside what it shows, and says where."""
    first = given.source[0] if one.several_sources else given.source
    beside = first if os.path.isdir(first) else os.path.dirname(first)
    formats = None if given.formats is None else output.read_formats(given.formats)
    files = output.targets(given.output or os.path.join(beside, one.name), formats)
    with shown_units.chosen(_choice(one, given)):
        draw_picture(one.picture(given), files)
    if not given.output:
        for path in files.values():
            print(f"figure: {os.path.relpath(path)}")


def add_units(one, parser):
    """The options of the units that this picture obeys."""
    if "speed" in one.units:
        parser.add_argument("--speed-unit", metavar="UNIT", choices=shown_units.SPEED_UNITS, help="hz or rpm, of shaft speeds (default: as in the "
                            "configuration)")
    if "length" in one.units:
        parser.add_argument("--length-unit", metavar="UNIT", choices=tuple(shown_units.LENGTH_UNITS), help="mm, um or mil "
                            "(a thousandth of an inch), of displacements (default: by their size)")
    if "peak_to_peak" in one.units:
        parser.add_argument("--peak-to-peak", action="store_true", help="amplitudes as twice their size, as vibration is "
                            "often given")


def _choice(one, given):
    return shown_units.Choice(
        given.speed_unit if "speed" in one.units else None,
        given.length_unit if "length" in one.units else None,
        given.peak_to_peak if "peak_to_peak" in one.units else False,
    )


def draw_picture(picture, files):
    """`files`: a dict from each format to the absolute name of its file."""
    with gnuplot.drawing(picture, tuple(files)) as drawn:
        for name, path in files.items():
            output.place(drawn[name], path)
