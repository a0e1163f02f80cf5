"""ctrl_c_test.py APPS CONFIGS: SIGINT ends the programs below in the middle of long work with exit code 130 and a message
of what is kept. Prints how long each took to end; a hang fails, a slow machine does not.
"""

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
chart = (configs / "ring_figure20.yaml").read_text(encoding="utf-8").replace("count: 179", "count: 9000")
chart = chart.replace("count: 301", "count: 401")

# Work that takes minutes: program, arguments, and files that it leaves behind.
long_runs = {
    "rubsweep, short cells": ("rubsweep", [annulus], {"config.yaml", "map.journal", "map.partial.csv"}),
    "rubsweep, one long cell": (
        "rubsweep",
        [stop, "--set", "sweep={speed_hz: 70, whirl_ratio: 0.9}", "--set", "solver.method=adaptive",
         "--set", "response={floquet_proof: off, max_revolutions: 1000000, window_revolutions: 4096}"],
        {"config.yaml", "map.journal", "map.partial.csv"}),
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
    "rubbranch, curves": ("rubbranch", [configs / "gallery/orbit_boundaries.yaml", "--cell", "75,0.4", "--curve",
                                        "whirl_ratio", "--points", "100000"], set()),
    "ringstab": ("ringstab", ["chart.yaml"], {"chart.partial.csv"}),
}


def processor_s(process: subprocess.Popen) -> float:
    fields = Path(f"/proc/{process.pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def interrupt(name: str, program: str, arguments: list, left: set, folder: Path) -> None:
    output = folder / "out"
    (folder / "chart.yaml").write_text(chart, encoding="utf-8")
    command = [apps / program, *arguments, "--output", output]
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        # Startup and reading take a small part of this.
        while process.poll() is None and processor_s(process) < 0.5:
            time.sleep(0.01)
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        try:
            message = process.communicate(timeout=hang_s)[1]
        except subprocess.TimeoutExpired:
            process.kill()
            sys.exit(f"{name}: hangs")
    lines = message.strip().splitlines()
    if process.returncode != 130 or not lines or "interrupted;" not in lines[-1]:
        sys.exit(f"{name}: exit code {process.returncode}, {message!r}")
    found = {path.name for path in output.iterdir()} if output.exists() else set()
    if found != left:
        sys.exit(f"{name}: leaves {sorted(found)}, not {sorted(left)}")
    print(f"{name}: {time.monotonic() - begin:.2f} s: {lines[-1]}")


for name, (program, arguments, left) in long_runs.items():
    with tempfile.TemporaryDirectory() as folder:
        interrupt(name, program, arguments, left, Path(folder))
