"""The program behind bode.sh, which says what it does."""

import os

import bode_layout
import captions
import gnuplot
from command import run_program


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    directory, output = (os.path.abspath(name) for name in arguments[:2])
    bode = bode_layout.Bode(directory)
    files = {f"sensor_{i}": bode.lines(i) for i in bode.sensors}
    files["names.gp"] = [f'name_{i} = "{name}"' for i, name in zip(bode.sensors, bode.names())]
    gnuplot.draw_files(
        "bode.gp",
        files,
        output,
        captions.headed(arguments[2], bode.config),
        str(len(bode.sensors)),
        bode.unit,
        " ".join(bode.critical()),
        captions.byline(bode.config),
        bode.speed.label,
    )


if __name__ == "__main__":
    run_program(main, usage="bode.sh DIR OUTPUT_BASENAME HEADING", least=3, most=3)
