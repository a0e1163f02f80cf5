"""A domain map: one colour for each kind of motion, and the boundaries that rubbranch --map found."""

import os

from rubplot import csv_table, domain_map, heading, map_axes
from rubplot.failure import Failure, require_readable
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand


def options(parser):
    parser.add_argument("--fade", action="store_true", help="mix the colour of a cell with white by its robust_share")
    parser.add_argument("--natural-frequency-hz", metavar="F", type=float, help="draw speeds over this frequency where the "
                        "configuration has none, as that of a rotor kit")


def picture(given):
    identified_hz = given.natural_frequency_hz
    plane = map_axes.read_plane(given.source, identified_hz)
    if given.fade and plane.config.get("response.robustness") != "probability":
        raise Failure(f"{plane.map_file} has no column robust_share: response.robustness is not probability")
    cells, boundaries = _in_si(plane, "robust_share" if given.fade else None)
    axes = plane.axes(max(cell.y for cell in cells))
    cells, boundaries = domain_map.scaled(cells, boundaries, axes[0].factor, axes[1].factor)
    scales = map_axes.logarithmic(axes, [cell.x for cell in cells], [cell.y for cell in cells])
    present = " ".join(sorted({cell.kind for cell in cells}))
    return Picture(
        "map.gp",
        (
            heading.text(given.heading, plane.config, identified_hz),
            f" {present} ",
            domain_map.label_text(domain_map.labels(cells)),
            map_axes.label(axes[0]),
            map_axes.label(axes[1]),
            " ".join(boundaries),
            " ".join((["fade"] if given.fade else []) + [map_axes.scale_words(scales)]),
        ),
        {"cells": [*domain_map.cell_lines(cells, scales), *domain_map.boundary_lines(boundaries)]},
        ("motion_kinds.gp",),
    )


def _in_si(plane, strength):
    """Cells, of a refined map those too that were not computed, and boundaries."""
    cells = domain_map.read_cells(plane.map_file, plane.up, plane.natural_hz, plane.across, strength)
    boundaries = {}
    if plane.across == "speed_hz":
        file = os.path.join(os.path.dirname(plane.map_file), "boundaries.csv")
        boundaries = domain_map.read_boundaries(file, plane.up, plane.natural_hz, csv_table.digest(plane.map_file))
    if "sweep.refine.levels" in plane.config:
        cells = _painted(plane, cells)
    return cells, boundaries


def _painted(plane, computed):
    """All cells of a refined map, those that were computed as they are given."""
    file = os.path.join(os.path.dirname(plane.map_file), "painted.csv")
    if not os.path.exists(file):
        raise Failure(f"{file}: is not there, which has the cells that a refined map does not compute: the same "
                      "rubsweep command again writes it")
    require_readable(file)
    if csv_table.digest(file) != csv_table.digest(plane.map_file):
        raise Failure(f"{file}: is of another map than {plane.map_file}")
    known = {(cell.x, cell.y): cell for cell in computed}
    cells = domain_map.read_cells(file, plane.up, plane.natural_hz, plane.across)
    return [known.get((cell.x, cell.y), cell) for cell in cells]


SUBCOMMAND = Subcommand(
    name="map",
    summary="domain map of rubsweep, with the boundaries of rubbranch --map where they are",
    description="""Draws a map.csv, or that of a directory, in the plane and the units in which its sweep was written. Takes
rotor, stops and kick under the heading from config.yaml beside it. The lines of boundaries.csv
beside it are drawn where they belong to the same map.""",
    source="DIR|MAP.csv",
    heading="Rub domains after a kick",
    picture=picture,
    units=("speed",),
    options=options,
    examples=("results/benchmark/one_side", "results/mine --fade --output mine.pdf",
              "results/rotor_kit/map.csv --natural-frequency-hz 30.2 --formats png,svg,pdf"),
)
