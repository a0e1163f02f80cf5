"""The arithmetic behind mpi_efficiency.sh.

mpi_efficiency.py ONE RANKS COUNT: the files hold the times of runs by one process and by COUNT ranks, a line "REAL USER
SYSTEM" in seconds for each.
"""

import statistics

from command import run_program


def medians(lines):
    """Medians of the time on the wall clock and of the processor time, in seconds."""
    times = [tuple(map(float, line.split())) for line in lines]
    return statistics.median(real for real, _, _ in times), statistics.median(user + system for _, user, system in times)


def report(one, ranks, count):
    (one_wall, one_processor), (wall, processor) = one, ranks
    yield "one process: %.2f s, %.2f s of processor time" % (one_wall, one_processor)
    yield "%d ranks: %.2f s, %.2f s of processor time" % (count, wall, processor)
    efficiency = 100 * one_wall / (count * wall), 100 * one_processor / processor
    yield "efficiency: %.0f %% on the wall clock, %.0f %% in processor time" % efficiency


def main(arguments):
    found = []
    for path in arguments[:2]:
        with open(path, encoding="utf-8") as file:
            found.append(medians(file))
    for line in report(*found, int(arguments[2])):
        print(line)


if __name__ == "__main__":
    run_program(main, usage="mpi_efficiency.py ONE RANKS COUNT", least=3, most=3)
