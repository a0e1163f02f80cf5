"""Traces of rubtrace: time history, orbit and full spectrum, one row of panels for each."""

import os

from rubplot import captions, configuration, trace_layout
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand


def options(parser):
    parser.add_argument("--revolutions", metavar="N", type=int, default=40, help="the history shows the first N revolutions "
                        "that were written, of a negative N the last ones (default: %(default)s)")


def picture(given):
    rows = [trace_layout.lay_out(trace, given.revolutions) for trace in given.source]
    highest = max(row.assignments["highest"] for row in rows)
    files = {"rows.gp": _assignment_lines(rows)}
    for i, row in enumerate(rows, 1):
        files |= {f"{i}.{name}": lines for name, lines in row.files.items()}
        files[f"{i}.labels"] = row.label_lines(highest)
    config = configuration.read_configuration(os.path.join(given.source[0], "config.yaml"))
    return Picture("trace.gp", (captions.headed(given.heading, config), str(len(rows)), captions.byline(config)), files)


def _assignment_lines(rows):
    for array in rows[0].assignments:
        yield f"array {array}[{len(rows)}]"
        yield from (f"{array}[{i}] = {row.assignments[array]}" for i, row in enumerate(rows, 1))


SUBCOMMAND = Subcommand(
    name="trace",
    summary="time history, orbit and full spectrum of single cells (rubtrace)",
    description="""Draws what rubtrace wrote into each DIR as a row of panels: time history, orbit and full spectrum. Orbit and
section points are those of the end of the run.""",
    source="DIR",
    several_sources=True,
    heading="One cell under the lens",
    picture=picture,
    units=("speed", "length"),
    options=options,
    examples=("results/my_trace --output cell.pdf", "results/calm results/rub --revolutions -20 --heading 'Calm and rub'"),
)
