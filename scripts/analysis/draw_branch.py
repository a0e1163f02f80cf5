"""The program behind branch_figure.sh, which says what it does."""

import os

import branch_layout
import configuration
import gnuplot
import map_heading
from command import run_program


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    directory, output = (os.path.abspath(name) for name in arguments[:2])
    branches = branch_layout.Branches(directory)
    config = configuration.read_configuration(os.path.join(directory, "config.yaml"))
    marks = [kind for kind in branch_layout.MARKS if branches.mark_lines(kind)]
    files = {kind: branches.mark_lines(kind) for kind in marks}
    for order in branches.orders():
        # An empty file would not be read: a line without numbers is.
        files[f"stable_{order}"] = ["NaN NaN", *branches.line_lines(order, True)]
        files[f"unstable_{order}"] = ["NaN NaN", *branches.line_lines(order, False)]
    gnuplot.draw_files(
        "branch_figure.gp",
        files,
        output,
        map_heading.heading(arguments[2], config, varied=(branches.parameter,)),
        " ".join(str(order) for order in branches.orders()),
        " ".join(marks),
        branches.parameter,
    )


if __name__ == "__main__":
    run_program(main, usage="branch_figure.sh DIR OUTPUT_BASENAME HEADING", least=3, most=3)
