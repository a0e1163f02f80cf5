"""ctrl_c_test.py APPS CONFIGS [NAME]...: SIGINT ends the programs below, or those of these names, in the middle of long work
with exit code 130 and a message of what is kept. Prints how long each took to end; a hang fails, a slow machine does not.
"""

import math
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

apps, configs = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
annulus = configs / "reference/figure12_annulus_offset.yaml"
stop = configs / "benchmark/one_side.yaml"
cell = ("--speed-hz", "70", "--whirl-ratio", "0.9")
hang_s = 120
chart = (configs / "ring/figure20.yaml").read_text(encoding="utf-8").replace("count: 179", "count: 9000")
chart = chart.replace("count: 301", "count: 401")

# A map, an experiment and a recording of long work, which are made beforehand: name -> commands.
map_of_many = ("--set", "sweep.speed_hz.count=132", "--set", "sweep.whirl_ratio.count=40")
map_to_read = [("rubsweep", [stop, *map_of_many, "--output", "map", "--quiet"])]
prepared = {
    "rubsweep, the report": [("rubsweep", [stop, *map_of_many, "--output", "out", "--quiet"])],
    "rubreport": map_to_read,
    "rubbranch, a map": map_to_read,
    "rubfit": [("rubtrace", [configs / "minimal.yaml", "--free-response", "--duration-s", "20", "--noise-m", "5e-6", "--output",
                             "free", "--quiet"])],
}


def write_recording(path: Path) -> None:
    """Two probes and the mark of a shaft that turns at 70 Hz, for two minutes."""
    with open(path, "w", encoding="ascii") as file:
        file.write("t,KP,X,Y\ns,V,um,um\n")
        for k in range(480000):
            turn = 2 * math.pi * 70 * k / 4000
            mark = 1 if (70 * k) % 4000 > 200 else 0
            file.write(f"{k / 4000:.6f},{mark},{20 * math.cos(turn):.3f},{20 * math.sin(turn) + 5 * math.cos(turn / 2):.3f}\n")
    path.with_suffix(".yaml").write_text(
        "time: t\nkeyphasor: {column: KP, mark: dark}\nprobes:\n  - {column: X, angle_deg: 0}\n  - {column: Y, angle_deg: 90}\n",
        encoding="ascii")


# Work that takes minutes, or longer than it is left alone: program, arguments, and files that it leaves behind; None: any.
long_runs = {
    "rubsweep, short cells": ("rubsweep", [annulus], {"config.yaml", "map.journal", "map.partial.csv"}),
    "rubsweep, one long cell": (
        "rubsweep",
        [stop, "--set", "sweep={speed_hz: 70, whirl_ratio: 0.9}", "--set", "solver.method=adaptive",
         "--set", "response={floquet_proof: off, max_revolutions: 1000000, window_revolutions: 4096}"],
        {"config.yaml", "map.journal", "map.partial.csv"}),
    "rubsweep, the report": ("rubsweep", [stop, *map_of_many, "--report", "--threads", "1"], {"config.yaml", "map.csv"}),
    "rubbasin": ("rubbasin", [configs / "gallery/basin_slice.yaml", "--cell", "80,0.5", "--plane", "y,vy",
                              "--grid", "401x401"], {"config.yaml", "map.journal", "map.partial.csv"}),
    "rubtrace, one motion": ("rubtrace", [annulus, *cell, "--revolutions", "1000000", "--last-revolutions", "9"], set()),
    "rubtrace, run-up through rub": (
        "rubtrace", [configs / "gallery/run_up.yaml", "--run-up", "24:50:0.02", "--eccentricity-m", "2e-4",
                     "--with-stops"], set()),
    "rubtrace, free response": (
        "rubtrace", [configs / "gallery/hammer_test.yaml", "--free-response", "--duration-s", "1000"], set()),
    "rubtrace, Campbell diagram": ("rubtrace", [configs / "rotor_kit.yaml", "--campbell", "0:200:10000"], set()),
    "rubtrace, design check": ("rubtrace", [configs / "reference/rotor_kit.yaml", "--design-check"], set()),
    "rubbench": ("rubbench", [configs / "gallery/work_precision.yaml", "--cell", "90,0.6", "--turns", "1000"], set()),
    "rubline": ("rubline", [annulus, "--along", "speed_hz", "--from", "60", "--to", "200", "--count", "10000",
                            "--whirl-ratio", "0.9"], {"config.yaml", "line.csv", "bifurcation.csv", "cascade.csv"}),
    "rubbranch": ("rubbranch", [annulus, "--cell", "70,0.6", "--from", "20", "--to", "400", "--points", "100000"], set()),
    "rubbranch, curves": ("rubbranch", [configs / "light_casing/one_side.yaml", "--cell", "80,0.4", "--switch", "--curve",
                                        "whirl_ratio", "--points", "100000"], set()),
    "rubbranch, a map": ("rubbranch", ["--map", "map"], {"families.journal"}),
    "rubreport": ("rubreport", ["map", "--orbits", "5280", "--threads", "1"], set()),
    "rubdata": ("rubdata", [configs / "recordings/rub_recordings.yaml"], None),
    "rubfit": ("rubfit", [configs / "minimal.yaml", "--set", "rotor.damping_ratio=0.03", "--ring-down", "free/sensors.csv", "--from-s",
                          "0.006", "--fit", "rotor.natural_frequency_hz", "--fit", "rotor.damping_ratio", "--fit",
                          "hit_s=-0.002:0.002", "--starts", "100"], None),
    "rubscope": ("rubscope", ["recording.csv"], set()),
    "ringstab": ("ringstab", ["chart.yaml"], {"chart.partial.csv"}),
}


def children(pid: int) -> list[int]:
    return [int(word) for task in Path(f"/proc/{pid}/task").iterdir()
            for word in (task / "children").read_text(encoding="ascii").split()]


def processor_s(pid: int) -> float:
    """Time of a process and its children; 0 of one that is gone."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK") + sum(map(processor_s, children(pid)))
    except (FileNotFoundError, ProcessLookupError):
        return 0


def interrupt(name: str, program: str, arguments: list, left, folder: Path, how: str) -> None:
    """`how`: SIGINT or SIGTERM to the program, or a SIGINT of the terminal, which goes to its children as well."""
    output = folder / "out"
    (folder / "chart.yaml").write_text(chart, encoding="utf-8")
    for first, words in prepared.get(name, ()):
        subprocess.run([apps / first, *words], cwd=folder, check=False, stdout=subprocess.DEVNULL)
    if name == "rubscope":
        write_recording(folder / "recording.csv")
    command = [apps / program, *arguments, "--output", output]
    number = signal.SIGTERM if how == "kill" else signal.SIGINT
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          start_new_session=True) as process:
        # Startup and reading take a small part of this.
        while process.poll() is None and processor_s(process.pid) < 0.5:
            time.sleep(0.01)
        begin = time.monotonic()
        started = children(process.pid)
        if how == "terminal":
            os.killpg(process.pid, number)
        else:
            process.send_signal(number)
        try:
            message = process.communicate(timeout=hang_s)[1]
        except subprocess.TimeoutExpired:
            process.kill()
            sys.exit(f"{name}: hangs")
    lines = message.strip().splitlines()
    if process.returncode != 128 + number or sum("interrupted;" in line for line in lines) != 1:
        sys.exit(f"{name}, {how}: exit code {process.returncode}, {message!r}")
    if "interrupted;" not in lines[-1] or not lines[-1].startswith(f"{program}: "):
        sys.exit(f"{name}, {how}: {message!r}")
    if any(Path(f"/proc/{pid}").exists() for pid in started):
        sys.exit(f"{name}, {how}: a child goes on")
    found = {path.name for path in output.iterdir()} if output.exists() else set()
    if left is not None and found != left:
        sys.exit(f"{name}: leaves {sorted(found)}, not {sorted(left)}")
    print(f"{name}: {time.monotonic() - begin:.2f} s: {lines[-1]}")


for name, (program, arguments, left) in long_runs.items():
    if sys.argv[3:] and name not in sys.argv[3:]:
        continue
    for how in ("SIGINT", "kill", "terminal") if name == "rubsweep, the report" else ("SIGINT",):
        with tempfile.TemporaryDirectory() as folder:
            interrupt(name, program, arguments, left, Path(folder), how)
