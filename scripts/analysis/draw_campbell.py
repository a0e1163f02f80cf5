"""The program behind campbell.sh, which says what it does."""

import os
import tempfile

import campbell_layout
import captions
import configuration
import gnuplot
from command import run_program


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    directory, output = (os.path.abspath(name) for name in arguments[:2])
    with tempfile.TemporaryDirectory() as work:
        shapes = campbell_layout.lay_out(directory, work)
        os.makedirs(os.path.dirname(output), exist_ok=True)
        config = configuration.read_configuration(os.path.join(directory, "config.yaml"))
        heading = captions.headed(arguments[2], config)
        gnuplot.draw("campbell.gp", work, output, heading, str(shapes), captions.byline(config))


if __name__ == "__main__":
    run_program(main, usage="campbell.sh DIR OUTPUT_BASENAME HEADING", least=3, most=3)
