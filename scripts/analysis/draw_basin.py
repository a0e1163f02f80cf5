"""The program behind basin_figure.sh, which says what it does."""

import os

import basin_layout
import gnuplot
import map_heading
from command import run_program


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    directory, output = (os.path.abspath(name) for name in arguments[:2])
    slice_ = basin_layout.Slice(directory)
    named = slice_.attractors[: basin_layout.MOST_NAMED]
    wall = slice_.wall()
    gnuplot.draw_files(
        "basin.gp",
        {"starts": basin_layout.box_lines(slice_)},
        output,
        map_heading.heading(arguments[2], slice_.config, varied=slice_.columns),
        " ".join(f"{attractor.kind} {attractor.rank}" for attractor in named),
        "".join(attractor.legend + "|" for attractor in named),
        "%d" % max(0, len(slice_.attractors) - len(named)),
        basin_layout.axis_label(slice_.columns[0]),
        basin_layout.axis_label(slice_.columns[1]),
        "" if wall is None else "%d %.17g" % wall,
    )


if __name__ == "__main__":
    run_program(main, usage="basin_figure.sh DIR OUTPUT_BASENAME HEADING", least=3, most=3)
