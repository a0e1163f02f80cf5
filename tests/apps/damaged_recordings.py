"""Recordings that are damaged or wrong, one fault each, and what rubscope says of them.

damaged_recordings.py RUBSCOPE [EXPECTED.txt]: writes them into a new directory, runs RUBSCOPE on each, and prints its exit
code and what it said. With EXPECTED.txt it prints the difference instead, and ends with 1 where there is one; without, what
it prints is that file."""

import difflib
import math
import os
import struct
import subprocess
import sys
import tempfile

RATE_HZ, SPEED_HZ, ROWS = 2000, 50, 1000
HEADER = "time [s],X [um],Y [um],KP [V]"
INSTRUMENT = """time: time
keyphasor: {column: KP}
probes:
  - {column: X, angle_deg: 0}
  - {column: Y, angle_deg: 90}
"""
# Without a column of times and a keyphasor, as a file of samples has it.
SAMPLES = """speed_hz: 50
probes: [{column: channel 1, angle_deg: 0, gain_mv_per_um: 8, range_v: 1}]
"""


def signal(t, speed_hz=SPEED_HZ):
    turns = speed_hz * t
    return (40 * math.cos(2 * math.pi * turns) + 0.01 * math.sin(7919 * t), 30 * math.sin(2 * math.pi * turns),
            -12 if turns % 1 < 0.1 else -2)


def rows(rate_hz=RATE_HZ, count=ROWS, speed_hz=SPEED_HZ):
    return [[f"{k / rate_hz:.6f}", *(f"{value:.4f}" for value in signal(k / rate_hz, speed_hz))] for k in range(count)]


def text(table, header=HEADER):
    return "\n".join([header] + [",".join(row) for row in table]) + "\n"


def with_cells(places, table=None):
    """A whole recording with other cells: {(row, column): cell}."""
    table = table or rows()
    for (row, column), cell in places.items():
        table[row][column] = cell
    return text(table)


def column_as(column, change):
    """A whole recording whose column is another: `change` takes row and cell."""
    return with_cells({(k, column): change(k, row[column]) for k, row in enumerate(rows())})


def without_marks(numbers):
    """The mark passes unseen in these turns."""
    return column_as(3, lambda k, cell: "-2" if int(k * SPEED_HZ / RATE_HZ) in numbers else cell)


def wave(samples, channels=1, rate_hz=RATE_HZ, said_bytes=None):
    data = struct.pack(f"<{len(samples)}h", *samples)
    size = len(data) if said_bytes is None else said_bytes
    return (b"RIFF" + struct.pack("<I", 36 + size) + b"WAVEfmt "
            + struct.pack("<IHHIIHH", 16, 1, channels, rate_hz, rate_hz * 2 * channels, 2 * channels, 16)
            + b"data" + struct.pack("<I", size) + data)


def tone():
    return [int(20000 * math.cos(2 * math.pi * SPEED_HZ * k / RATE_HZ)) for k in range(ROWS)]


def recordings():
    """Name of the fault, name of the file, its bytes, the text beside it."""
    whole = text(rows())
    yield "whole, for comparison", "whole.csv", whole, INSTRUMENT
    yield "empty", "empty.csv", "", INSTRUMENT
    yield "header alone", "header.csv", HEADER + "\n", INSTRUMENT
    yield "one row", "one_row.csv", text(rows()[:1]), INSTRUMENT
    yield "letters in a cell", "letters.csv", with_cells({(99, 1): "x1"}), INSTRUMENT
    yield "infinite cell", "infinite.csv", with_cells({(99, 1): "inf"}), INSTRUMENT
    yield "number out of range", "overflow.csv", with_cells({(99, 1): "1e999"}), INSTRUMENT
    yield "cells missing in a row", "few_cells.csv", whole.replace(",".join(rows()[99]), ",".join(rows()[99][:3])), INSTRUMENT
    yield "cell too many in a row", "many_cells.csv", with_cells({(99, 3): "-2,7"}), INSTRUMENT
    yield "last row cut off", "cut_row.csv", whole[:-12], INSTRUMENT
    yield "gap of three readings", "gap.csv", with_cells({(k, 1): "" for k in (500, 501, 502)}), INSTRUMENT
    yield "gaps all over", "gaps.csv", column_as(1, lambda k, cell: "NaN" if k % 60 == 0 else cell), INSTRUMENT
    yield "time goes back", "back.csv", with_cells({(99, 0): "0.001"}), INSTRUMENT
    yield "rows lost", "lost.csv", text(rows()[:500] + rows()[520:]), INSTRUMENT
    yield "time stands still", "still.csv", column_as(0, lambda k, cell: "0.0"), INSTRUMENT
    yield "uneven clock", "uneven.csv", column_as(0, lambda k, cell: f"{float(cell) + 1e-4 * (k % 3):.6f}"), INSTRUMENT
    yield "decimal commas and points", "commas.csv", whole.replace(",", ";").replace("0.049500", "0,049500"), INSTRUMENT
    yield "bytes that are no text", "bytes.csv", bytes(range(256)) * 40, INSTRUMENT
    yield "zeros at the end of a text", "zeros.csv", whole.encode()[:20000] + bytes(4096), INSTRUMENT
    yield "text in UTF-16", "utf16.csv", whole.encode("utf-16"), INSTRUMENT
    yield "unknown unit", "unit.csv", whole.replace("X [um]", "X [furlong]"), INSTRUMENT
    yield "no unit", "no_unit.csv", whole.replace("X [um]", "X"), INSTRUMENT
    yield "volts without a gain", "no_gain.csv", whole.replace("X [um]", "X [mV]"), INSTRUMENT
    yield "two columns of one name", "twice.csv", whole.replace("Y [um]", "X [um]"), INSTRUMENT
    yield "dead probe", "dead.csv", column_as(1, lambda k, cell: "3.2"), INSTRUMENT
    yield "clipped probe", "clipped.csv", column_as(1, lambda k, cell: f"{max(-25.0, min(25.0, float(cell)))}"), INSTRUMENT
    yield "dead keyphasor", "no_marks.csv", column_as(3, lambda k, cell: "-2"), INSTRUMENT
    yield "marks missing", "few_marks.csv", without_marks({7, 8, 15}), INSTRUMENT
    yield "mark too many", "many_marks.csv", with_cells({(300, 3): "-12", (540, 3): "-12"}), INSTRUMENT
    yield "fewer turns than four", "short.csv", text(rows()[:100]), INSTRUMENT
    yield "too few readings a turn", "slow.csv", text(rows(rate_hz=110, count=400)), INSTRUMENT
    yield "vibration above half the rate", "alias.csv", column_as(1, lambda k, cell: f"{float(cell) + 20 * math.cos(math.pi * 0.97 * k):.4f}"), INSTRUMENT
    yield "speed that is wrong", "speed.csv", whole, INSTRUMENT.replace("keyphasor: {column: KP}", "speed_hz: 47.3")
    yield "threshold beyond the signal", "threshold.csv", whole, INSTRUMENT.replace("{column: KP}", "{column: KP, threshold: -20}")
    yield "stretch beyond the recording", "stretch.csv", whole, INSTRUMENT + "from_s: 3\n"
    yield "column that is not there", "column.csv", whole, INSTRUMENT.replace("column: Y", "column: Z")
    yield "two clocks", "clocks.csv", whole, INSTRUMENT + "sampling_rate_hz: 2000\n"
    yield "sound file cut off", "cut.wav", wave(tone())[:1000], SAMPLES
    yield "sound file without samples", "silent.wav", wave([]), SAMPLES
    yield "sound file at no rate", "rate.wav", wave(tone(), rate_hz=0), SAMPLES
    yield "sound file of one level", "level.wav", wave([1000] * ROWS), SAMPLES
    yield "MATLAB file cut off", "cut.mat", b"MATLAB 5.0 MAT-file" + b" " * 105 + b"\x00\x01IM" + b"\x0e\x00\x00\x00", SAMPLES


def said(rubscope, directory):
    """Lines on all recordings."""
    for number, (fault, name, content, instrument) in enumerate(recordings()):
        path = os.path.join(directory, name)
        with open(path, "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        with open(os.path.splitext(path)[0] + ".yaml", "w", encoding="utf-8") as file:
            file.write(instrument)
        done = subprocess.run([rubscope, name], cwd=directory, check=False, capture_output=True, timeout=60)
        if number:
            yield ""
        yield f"{fault} ({name}): exit {done.returncode}"
        heard = done.stderr.decode(errors="backslashreplace").splitlines()
        kept = ("motion", "warning", "speed")
        heard += [line for line in done.stdout.decode().splitlines() if line.startswith(kept)]
        yield from (f"  {line}" for line in heard)


def main():
    with tempfile.TemporaryDirectory() as directory:
        found = list(said(os.path.abspath(sys.argv[1]), directory))
    if len(sys.argv) == 2:
        print("\n".join(found))
        return 0
    with open(sys.argv[2], encoding="utf-8") as file:
        expected = file.read().splitlines()
    difference = list(difflib.unified_diff(expected, found, "expected", "found", lineterm=""))
    print("\n".join(difference))
    return 1 if difference else 0


if __name__ == "__main__":
    sys.exit(main())
