"""written_elsewhere_test.py RUBSCOPE: one recording as Octave, SciPy, h5py and SoX write it, read by RUBSCOPE.

Each file has the verdict of the same recording as CSV, and the same line of 1X. A program that this machine does not have is
left out by name; ends with 77 where there is none of them."""

import csv
import math
import os
import shutil
import subprocess
import sys
import tempfile

RATE_HZ, SPEED_HZ, COUNT, GAIN_V_PER_M = 5000, 71.3, 4000, 8000.0
COLUMNS = """time: t_s
keyphasor: {column: keyphasor_v}
probes: [{column: x_m, angle_deg: 0}, {column: y_m, angle_deg: 90}]
"""
MATRIX = """sampling_rate_hz: 5000
keyphasor: {column: data_3}
probes: [{column: data_1, angle_deg: 0, unit: m}, {column: data_2, angle_deg: 90, unit: m}]
"""
SOUND = """keyphasor: {column: channel 3}
probes:
  - {column: channel 1, angle_deg: 0, gain_mv_per_um: 8, range_v: 1}
  - {column: channel 2, angle_deg: 90, gain_mv_per_um: 8, range_v: 1}
"""


def recording():
    """Rows of t_s, x_m, y_m, keyphasor_v: a 1/2 motion with a mark that is as long as a few readings."""
    for k in range(COUNT):
        turn = SPEED_HZ * k / RATE_HZ + 0.4
        noise = 1e-7 * math.sin(7919.0 * k * k)
        yield (k / RATE_HZ, 4e-5 * math.cos(2 * math.pi * turn) + 1e-5 * math.cos(math.pi * turn) + noise,
               3e-5 * math.sin(2 * math.pi * turn) - noise, -12.0 if turn % 1 < 0.1 else -2.0)


MODULES = {"SciPy": "scipy.io, numpy", "h5py": "h5py, numpy"}


def python_with(program):
    """A Python that has the modules of SciPy or h5py; None without."""
    for path in (shutil.which("python3"), "/usr/bin/python3"):
        if path and subprocess.run([path, "-c", f"import {MODULES[program]}"], check=False, capture_output=True).returncode == 0:
            return path
    return None


def octave(options, variables, name):
    read = "d = dlmread('whole.csv', ',', 1, 0); t_s = d(:,1); x_m = d(:,2); y_m = d(:,3)'; keyphasor_v = d(:,4);"
    fields = "s.t_s = t_s; s.x_m = x_m; s.y_m = y_m; s.keyphasor_v = keyphasor_v; data = single([x_m y_m' keyphasor_v]);"
    return ["octave-cli", "--no-gui", "--norc", "--eval", f"{read} {fields} save('{options}', '{name}', {variables});"]


def scipy(options, name):
    return [python_with("SciPy"), "-c", "import numpy, scipy.io\n"
            "t, x, y, k = numpy.loadtxt('whole.csv', delimiter=',', skiprows=1).T\n"
            f"scipy.io.savemat('{name}', dict(t_s=t, x_m=x, y_m=y, keyphasor_v=k), {options})\n"]


def h5py(name):
    """MATLAB 7.3 is HDF5 behind 512 bytes of its own, each variable on its side and with its class, a C string."""
    return [python_with("h5py"), "-c", "import h5py, numpy\n"
            "t, x, y, k = numpy.loadtxt('whole.csv', delimiter=',', skiprows=1).T\n"
            "text = h5py.h5t.C_S1.copy()\n"
            "text.set_size(6)\n"
            f"with h5py.File('{name}', 'w', userblock_size=512) as file:\n"
            "    for key, column in dict(t_s=t, x_m=x, y_m=y, keyphasor_v=k).items():\n"
            "        data = file.create_dataset(key, data=column.reshape(1, -1))\n"
            "        scalar = h5py.h5s.create(h5py.h5s.SCALAR)\n"
            "        h5py.h5a.create(data.id, b'MATLAB_class', text, scalar).write(numpy.array(b'double', dtype='S6'), text)\n"
            f"with open('{name}', 'r+b') as file:\n"
            "    file.write(b'MATLAB 7.3 MAT-file'.ljust(116) + bytes(8) + bytes([0, 2]) + b'IM')\n"]


def sox(options, name):
    return ["sox", "-D", "whole.dat", *options, name]


def writers():
    """Program, format, command that writes it, the file, the description of the instrument."""
    columns = "'t_s', 'x_m', 'y_m', 'keyphasor_v'"
    for options, what in (("-v4", "MATLAB 4"), ("-v6", "MATLAB 5"), ("-v7", "MATLAB 7, compressed")):
        name = f"octave{options}.mat"
        yield "octave-cli", what, octave(options, columns, name), name, COLUMNS
    yield ("octave-cli", "MATLAB 7, a structure", octave("-v7", "'s'", "structure.mat"), "structure.mat",
           COLUMNS.replace(": t_s", ": s.t_s").replace("column: ", "column: s."))
    yield "octave-cli", "MATLAB 7, a matrix of single precision", octave("-v7", "'data'", "matrix.mat"), "matrix.mat", MATRIX
    for options, what in (("format='4'", "MATLAB 4"), ("format='5'", "MATLAB 5"),
                          ("do_compression=True", "MATLAB 5, compressed")):
        name = f"scipy_{len(options)}.mat"
        yield "SciPy", what, scipy(options, name), name, COLUMNS
    yield "h5py", "MATLAB 7.3", h5py("h5py.mat"), "h5py.mat", COLUMNS
    for options, what in ((["-b", "16"], "WAV, 16 bit"), (["-b", "24"], "WAV, 24 bit"),
                          (["-e", "floating-point", "-b", "32"], "WAV, float")):
        name = f"sox_{options[-1]}_{len(options)}.wav"
        yield "sox", what, sox(options, name), name, SOUND


def is_here(program):
    return python_with(program) is not None if program in MODULES else shutil.which(program) is not None


def read(rubscope, work, name, instrument):
    """Verdict and line of 1X; raises where rubscope refuses the file."""
    with open(os.path.join(work, name + ".yaml"), "w", encoding="utf-8") as file:
        file.write(instrument)
    done = subprocess.run([rubscope, name, "--instrument", name + ".yaml", "--output", name + "_scope"], cwd=work, text=True,
                          check=False, capture_output=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip())
    verdict = next(line for line in done.stdout.splitlines() if line.startswith("motion"))
    with open(os.path.join(work, name + "_scope", "lines.csv"), encoding="utf-8") as file:
        lines = csv.DictReader(line for line in file if not line.startswith("#"))
        line = next(line for line in lines if float(line["order"]) == 1)
    amplitude, phase = float(line["amplitude_m"]), math.radians(float(line["phase_deg"]))
    return verdict, complex(amplitude * math.cos(phase), amplitude * math.sin(phase))


def main(rubscope):
    wrong, seen, missing = [], 0, set()
    with tempfile.TemporaryDirectory() as work:
        rows = list(recording())
        with open(os.path.join(work, "whole.csv"), "w", encoding="utf-8") as file:
            file.write("t_s,x_m,y_m,keyphasor_v\n" + "".join("%.9g,%.9g,%.9g,%g\n" % row for row in rows))
        with open(os.path.join(work, "whole.dat"), "w", encoding="utf-8") as file:
            file.write(f"; Sample Rate {RATE_HZ}\n; Channels 3\n" + "".join(
                f"{t:.9g} {GAIN_V_PER_M * x:.9g} {GAIN_V_PER_M * y:.9g} {mark / 13:.9g}\n" for t, x, y, mark in rows))
        verdict, one_x = read(rubscope, work, "whole.csv", COLUMNS)
        print(f"CSV: {verdict}, 1X {abs(one_x):.6g} m")
        for program, what, command, name, instrument in writers():
            if not is_here(program):
                missing.add(program)
                continue
            written = subprocess.run(command, cwd=work, check=False, capture_output=True, text=True)
            if written.returncode != 0:
                wrong.append(f"{program}, {what}: cannot be written: {written.stderr.strip()}")
                continue
            seen += 1
            try:
                other_verdict, other_one_x = read(rubscope, work, name, instrument)
            except RuntimeError as error:
                wrong.append(f"{program}, {what}: {error}")
                continue
            off = abs(other_one_x - one_x) / abs(one_x)
            print(f"{program}, {what}: {other_verdict}, 1X off by {off:.2g}")
            # The step of 16 bits is 1e-4 of 1X, and many readings share it.
            if other_verdict != verdict or off > 1e-5:
                wrong.append(f"{program}, {what}: {other_verdict}, 1X off by {off:.2g}, expected {verdict}")
    for program in sorted(missing):
        print(f"left out: there is no {program}")
    print("\n".join(wrong))
    return 77 if seen == 0 else 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1])))
