"""Simulated readings as an instrument would have recorded them.

as_recorded.py SENSORS.csv OUT.csv --speed-hz FROM [--rate-hz-per-s R] [options]: takes t_s, sensor_0_m, sensor_1_m, ... of
rubtrace and writes OUT.csv as a data logger does: time by its own clock, probes in millivolts with errors of their gains and
the run-out of the shaft, a keyphasor at a keyway. OUT.yaml beside it says what an engineer knows of it, OUT_truth.csv what he
does not."""

import argparse
import math
import os
import random
import sys

from rubplot import csv_table

GAIN_MV_PER_UM = 8.0
KEYWAY = 0.08  # share of a turn
DARK_V, BRIGHT_V = -12.0, -2.0


def parse(words):
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("sensors")
    parser.add_argument("out")
    parser.add_argument("--speed-hz", type=float, required=True, help="of the shaft at time 0")
    parser.add_argument("--rate-hz-per-s", type=float, default=0.0)
    parser.add_argument("--mark-deg", type=float, default=0.0, help="angle of the shaft at which the keyway passes")
    parser.add_argument("--run-out-um", type=float, default=0.0, help="of 1X and, half of it, of 2X, with phases of its own")
    parser.add_argument("--gain-error", type=float, default=0.0, help="standard deviation, as a share")
    parser.add_argument("--clock-ppm", type=float, default=0.0, help="by which the clock of the logger is fast")
    parser.add_argument("--probes", default="0,90", help="directions of the sensors in degrees")
    parser.add_argument("--seed", type=int, default=1)
    return parser.parse_args(words)


def drawn(given, probes):
    """The numbers that nobody knows: name and value, in the order in which they are written."""
    random_number = random.Random(given.seed)
    truth = {"clock_ppm": given.clock_ppm, "mark_deg": given.mark_deg}
    for i in range(probes):
        truth[f"gain_{i}"] = 1 + random_number.gauss(0, given.gain_error)
        for order in (1, 2):
            truth[f"run_out_{i}_{order}x_um"] = given.run_out_um / order
            truth[f"run_out_{i}_{order}x_deg"] = random_number.uniform(-180, 180)
    return truth


def rows(given, columns, probes, truth):
    """Cells of the table, one row after the other."""
    for k, t in enumerate(columns["t_s"]):
        turns = given.speed_hz * t + given.rate_hz_per_s * t * t / 2
        passed = turns - given.mark_deg / 360
        cells = [t * (1 + 1e-6 * given.clock_ppm)]
        for i in range(probes):
            run_out = sum(truth[f"run_out_{i}_{order}x_um"]
                          * math.cos(2 * math.pi * order * turns + math.radians(truth[f"run_out_{i}_{order}x_deg"]))
                          for order in (1, 2))
            cells.append(GAIN_MV_PER_UM * truth[f"gain_{i}"] * (1e6 * columns[f"sensor_{i}_m"][k] + run_out))
        cells.append(DARK_V if passed - math.floor(passed) < KEYWAY else BRIGHT_V)
        yield cells


def instrument(directions):
    text = "time: time\nkeyphasor: {column: KP, mark: dark}\nprobes:\n"
    for i, angle in enumerate(directions):
        text += f"  - {{column: P{i}, angle_deg: {angle}, gain_mv_per_um: {GAIN_MV_PER_UM:g}}}\n"
    return text


def write_recording(given):
    directions = given.probes.split(",")
    names = ("t_s", *(f"sensor_{i}_m" for i in range(len(directions))))
    columns = {name: [] for name in names}
    for row in csv_table.read_table(given.sensors, *names):
        for name in names:
            columns[name].append(csv_table.number(row, name))
    truth = drawn(given, len(directions))
    stem = os.path.splitext(given.out)[0]
    with open(given.out, "w", encoding="utf-8") as file:
        file.write(";".join(["time [s]", *(f"P{i} [mV]" for i in range(len(directions))), "KP [V]"]) + "\n")
        for time, *readings, mark in rows(given, columns, len(directions), truth):
            file.write(";".join([f"{time:.8f}", *(f"{value:.3f}" for value in readings), f"{mark:g}"]) + "\n")
    with open(stem + ".yaml", "w", encoding="utf-8") as file:
        file.write(instrument(directions))
    with open(stem + "_truth.csv", "w", encoding="utf-8") as file:
        file.write("quantity,value\n" + "".join(f"{name},{value:.9g}\n" for name, value in truth.items()))


if __name__ == "__main__":
    write_recording(parse(sys.argv[1:]))
