"""The program behind slowest_cells.sh, which says what it does."""

import os
import resource
import subprocess
import tempfile

from command import run_program
from random_cells import text_of, with_kits
from rubplot import csv_table

HEADER = "cell,processor_s,class,proof,revolutions,status"


def processor_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run_cell(program, directory, number, limit_s):
    """(processor seconds, the row's words) of the configuration that is there."""
    out = os.path.join(directory, "out%d" % number)
    before = processor_s()
    ended = subprocess.run(
        [program, os.path.join(directory, "%d.yaml" % number), "--threads", "1", "--quiet", "--fresh", "--output", out],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit_s, limit_s)), check=False)
    used = processor_s() - before
    path = os.path.join(out, "map.csv")
    if not os.path.exists(path):
        return used, ("", "", "", "stopped" if ended.returncode < 0 else "refused")
    row = next(iter(csv_table.read_table(path, "class", "proof", "revolutions", "status")))
    return used, (row["class"], row["proof"], row["revolutions"], row["status"])


def measure(program, cells, seed, limit_s, directory, method):
    times = []
    for number in range(cells):
        cell = with_kits(seed, number)
        if method and cell["solver"]["method"] != method:
            continue
        with open(os.path.join(directory, "%d.yaml" % number), "w", encoding="utf-8") as stream:
            stream.write(text_of(cell))
        used, words = run_cell(program, directory, number, limit_s)
        times.append((used, number, words))
    return sorted(times, key=lambda time: (-time[0], time[1]))


def main(arguments):
    program = os.path.join(arguments[0], "rubsweep")
    cells, seed, limit_s = (int(text) for text in arguments[1:4])
    with tempfile.TemporaryDirectory() as own:
        directory = arguments[4] if len(arguments) > 4 else own
        method = arguments[5] if len(arguments) > 5 else ""
        os.makedirs(directory, exist_ok=True)
        print(HEADER)
        for used, number, words in measure(program, cells, seed, limit_s, directory, method):
            print("%d,%.3f,%s" % (number, used, ",".join(words)))


if __name__ == "__main__":
    run_program(main, "slowest_cells.sh BIN CELLS SEED LIMIT_S [DIRECTORY [METHOD]]", 4, 6)
