"""Lays out what ringstab wrote for the gnuplot scripts of the ring's figures. Behind ring_figure.sh.

ring_layout.py panel DIRECTORY FROM_RPM: curves of one run in the same directory, MODE.curve (rpm, real, imaginary part)
and onsets (rpm, kind), from FROM_RPM on.
ring_layout.py chart DIRECTORY OUTPUT: onsets of its chart by kind, OUTPUT.KIND (parameter, rpm), and OUTPUT.couplings,
every parameter at which growing roots merge: there two loads couple.
"""

import os

import csv_table
from command import Failure, run_program

DRAWN_KINDS = ("divergence", "flutter", "coupling", "real_merger")
CHART_KINDS = tuple(f"{kind}_{end}" for kind in ("coupling", "divergence", "flutter") for end in ("begin", "end"))


def lay_out_panel(directory, from_rpm):
    curves = {}
    eigenvalues = csv_table.read_table(
        os.path.join(directory, "eigenvalues.csv"), "speed_rpm", "mode", "real_per_s", "imaginary_rad_per_s"
    )
    for row in csv_table.between(eigenvalues, "speed_rpm", from_rpm):
        line = f"{row['speed_rpm']} {row['real_per_s']} {row['imaginary_rad_per_s']}\n"
        curves.setdefault(row["mode"], []).append(line)
    for mode, lines in curves.items():
        _write(os.path.join(directory, mode + ".curve"), lines)
    onsets = csv_table.read_table(os.path.join(directory, "onsets.csv"), "kind", "speed_rpm")
    drawn = (row for row in onsets if row["kind"].startswith(DRAWN_KINDS))
    later = csv_table.between(drawn, "speed_rpm", from_rpm)
    _write(os.path.join(directory, "onsets"), [f"{row['speed_rpm']} {row['kind']}\n" for row in later])


def lay_out_chart(directory, output):
    path = os.path.join(directory, "chart_onsets.csv")
    by_kind = {kind: [] for kind in CHART_KINDS}
    couplings = set()
    for row in csv_table.read_table(path, "kind", "speed_rpm", "note"):
        # The first column is named after the parameter of the chart.
        parameter = next(iter(row.values()))
        if row["kind"] in by_kind:
            by_kind[row["kind"]].append(f"{parameter} {row['speed_rpm']}\n")
        if row["kind"] == "real_merger" and "growing" in row["note"]:
            couplings.add(float(parameter))
    for kind, lines in by_kind.items():
        _write(f"{output}.{kind}", lines)
    _write(f"{output}.couplings", ["%g\n" % parameter for parameter in sorted(couplings)])


def _write(path, lines):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(lines)


def main(arguments):
    what, directory, third = arguments
    if what == "panel":
        lay_out_panel(directory, float(third))
    elif what == "chart":
        lay_out_chart(directory, third)
    else:
        raise Failure(f"neither panel nor chart: {what}")


if __name__ == "__main__":
    run_program(main, usage="ring_layout.py panel DIRECTORY FROM_RPM | chart DIRECTORY OUTPUT", least=3, most=3)
