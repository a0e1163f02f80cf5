"""Loads that rub on an elastic ring: real parts and frequencies over the speed, onsets as vertical lines."""

import os
import re
from dataclasses import dataclass

from rubplot import captions, csv_table, heading
from rubplot.failure import Failure
from rubplot.gnuplot import Picture
from rubplot.gnuplot_text import quoted
from rubplot.subcommand import Subcommand

DRAWN_KINDS = ("divergence", "flutter", "coupling", "real_merger")
# In the order of the legend; others stand behind them.
MODES = ("ring forward", "ring backward", "load 0 flexural", "load 1 flexural", "load 2 flexural", "load 0 radial")
_KIND = re.compile(r"[a-z_]+")


@dataclass(frozen=True)
class Panel:
    """One run: `curves` are lines (rpm, real part, imaginary part) by mode, `onsets` pairs of rpm and kind; real parts are
    drawn between -limit and limit, 0 for all of them."""

    title: str
    from_rpm: float
    to_rpm: float
    limit: float
    curves: dict
    onsets: list


def read_panel(directory, title, from_rpm=0.0, to_rpm=None, limit=0.0):
    """The results of ringstab in a directory, from a speed on, to the largest one where no other is given."""
    curves, largest = {}, from_rpm
    path = os.path.join(directory, "eigenvalues.csv")
    eigenvalues = csv_table.read_table(path, "speed_rpm", "mode", "real_per_s", "imaginary_rad_per_s")
    for row in csv_table.between(eigenvalues, "speed_rpm", from_rpm):
        line = f"{row['speed_rpm']} {row['real_per_s']} {row['imaginary_rad_per_s']}"
        curves.setdefault(row["mode"], []).append(line)
        largest = max(largest, csv_table.number(row, "speed_rpm"))
    if to_rpm is None:
        to_rpm = largest
    if not curves or to_rpm <= from_rpm:
        raise Failure(f"{path}: no speed above {from_rpm:g} rpm")
    return Panel(title, from_rpm, to_rpm, limit, curves, _read_onsets(os.path.join(directory, "onsets.csv"), from_rpm))


def _read_onsets(path, from_rpm):
    rows = csv_table.read_table(path, "kind", "speed_rpm")
    drawn = [row for row in rows if row["kind"].startswith(DRAWN_KINDS)]
    for row in drawn:
        if not _KIND.fullmatch(row["kind"]):
            raise Failure(f"{path}: '{row['kind']}' is no kind of onset")
    return [("%.17g" % csv_table.number(row, "speed_rpm"), row["kind"])
            for row in csv_table.between(drawn, "speed_rpm", from_rpm)]


def picture_of(panels, title, byline=""):
    """Panels beside and below each other under a title."""
    others = sorted({mode for panel in panels for mode in panel.curves} - set(MODES))
    modes = [*MODES, *others]
    lines = [f"array mode_name[{len(modes)}]"]
    lines += [f"mode_name[{k}] = {quoted(mode)}" for k, mode in enumerate(modes, 1)]
    lines += [f"array {name}[{len(panels)}]" for name in ("title", "from", "to", "limit", "drawn", "onsets")]
    files = {"panels.gp": lines}
    for p, panel in enumerate(panels, 1):
        numbers = [k for k, mode in enumerate(modes, 1) if mode in panel.curves]
        files |= {f"curve_{p}_{k}": panel.curves[modes[k - 1]] for k in numbers}
        lines += [
            f"title[{p}] = {quoted(panel.title)}",
            f"from[{p}] = {panel.from_rpm:.17g}",
            f"to[{p}] = {panel.to_rpm:.17g}",
            f"limit[{p}] = {panel.limit:.17g}",
            f"drawn[{p}] = '{' '.join(map(str, numbers))}'",
            f"onsets[{p}] = '{' '.join(f'{rpm} {kind}' for rpm, kind in panel.onsets)}'",
        ]
    return Picture("ring.gp", (title, str(len(panels)), str(len(modes)), byline), files)


def options(parser):
    parser.add_argument("--from-rpm", metavar="RPM", type=float, default=0.0, help="first speed (default: %(default)g)")
    parser.add_argument("--to-rpm", metavar="RPM", type=float, help="last speed (default: the largest one that was computed)")
    parser.add_argument("--real-limit", metavar="RATE", type=float, default=0.0,
                        help="draw real parts between -RATE and RATE, 1/s (default: all of them)")


def picture(given):
    heads = [csv_table.head(os.path.join(directory, "eigenvalues.csv")) for directory in given.source]
    several = len(given.source) > 1
    panels = []
    for directory, head in zip(given.source, heads):
        name = (several and head.get("title")) or os.path.basename(os.path.abspath(directory))
        panels.append(read_panel(directory, heading.plain(name), given.from_rpm, given.to_rpm, given.real_limit))
    own = captions.of_table(heads[0])
    return picture_of(panels, given.heading if several else captions.headed(given.heading, own), captions.byline(own))


SUBCOMMAND = Subcommand(
    name="ring",
    summary="eigenvalues of loads on an elastic ring over the speed, with onsets (ringstab)",
    description="""Draws what ringstab wrote into each DIR as a panel: real parts above, frequencies below, onsets of divergence,
flutter and coupling as vertical lines.""",
    source="DIR",
    several_sources=True,
    heading="Loads on an elastic ring",
    picture=picture,
    options=options,
    examples=("results/ring_figure10", "results/smooth results/rough --to-rpm 1000 --real-limit 2 --output ring.pdf"),
)
