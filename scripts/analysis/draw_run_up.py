"""The program behind run_up.sh, which says what it does."""

import os
import tempfile

import captions
import configuration
import gnuplot
import run_up_layout
from command import run_program


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    directory, output = (os.path.abspath(name) for name in arguments[:2])
    with tempfile.TemporaryDirectory() as work:
        shown = run_up_layout.lay_out(directory, work)
        config = configuration.read_configuration(os.path.join(directory, "config.yaml"))
        os.makedirs(os.path.dirname(output), exist_ok=True)
        gnuplot.draw(
            "run_up.gp",
            work,
            output,
            captions.headed(arguments[2], config),
            shown["speeds"],
            f"{shown['clearance']} {shown['angle']}",
            shown["orbits"],
            shown["reach"],
            shown["order"],
            captions.byline(config),
        )


if __name__ == "__main__":
    run_program(main, usage="run_up.sh DIR OUTPUT_BASENAME HEADING", least=3, most=3)
