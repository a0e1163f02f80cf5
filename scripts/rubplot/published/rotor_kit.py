"""The experiment on a rotor kit, as Ishibashi & Kawai describe it in section 5, by simulation: impulse and run-up identify
the rotor (1 ms samples with noise), then it rubs at 70 rev/s after a kick."""

import argparse
import os
import subprocess

from rubplot.failure import Failure
from rubplot.pictures import identification, map as domain_map, trace

STEM = "rotor_kit"
NOISE = ("--noise-m", "2e-6")


class RotorKit:
    """Writes reduction.txt, identification.txt, rub.txt, and what they are read from into a directory, and draws
    rotor_kit_{identification,rub,map}. A map that is there is not computed again."""

    def draw(self, _, sources, wanted):
        directory = wanted.map or os.path.join(sources.results, STEM)
        os.makedirs(directory, exist_ok=True)
        place = lambda name: os.path.join(directory, name)  # noqa: E731
        _report(place("reduction.txt"), [(None, sources.command("rubsweep", STEM, "--explain"))])
        _report(place("identification.txt"), [
            ("-- impulse at standstill, stops left out; 1 ms samples, noise of 2 um",
             sources.command("rubtrace", STEM, "--free-response", "--duration-s", "1", *NOISE, "--output",
                             place("free_response"))),
            ("-- run-up, 1 Hz/s, stops left out",
             sources.command("rubtrace", STEM, "--run-up", "10:60:1", "--eccentricity-m", "2e-5", *NOISE, "--output",
                             place("run_up"))),
        ], without="files ")
        print("-- rub at 70 rev/s, with the same readings of the sensors every 1 ms", flush=True)
        _report(place("rub.txt"), [(None, sources.command(
            "rubtrace", STEM, "--speed-hz", "70", "--whirl-ratio", "0.6", "--last-revolutions", "128", *NOISE, "--output",
            place("rub")))])
        if not os.path.exists(place("map.csv")):
            sources.run("rubsweep", STEM, "--output", directory)
        for name, picture in _pictures(directory):
            wanted.draw(picture, sources.figure(f"rotor_kit_{name}"))


def _pictures(directory):
    def picture(module, **given):
        return module.picture(argparse.Namespace(**given))

    yield "identification", picture(identification, source=directory, heading="Rotor kit")
    yield "rub", picture(
        trace, source=[os.path.join(directory, "rub")], revolutions=-20,
        heading="Rotor kit against a rub screw, the shaft as the sensors beside the disc see it: exact, and read every 1 ms")
    yield "map", picture(
        domain_map, source=directory, heading="Rub domains of the rotor kit after a kick", fade=False,
        natural_frequency_hz=identification.natural_frequency_hz(directory))


def _report(path, parts, without=None):
    """Runs the commands and writes what they say, each below a line of its own, to the file and on stdout; `without`
    leaves out the lines that begin so."""
    with open(path, "w", encoding="utf-8") as file:
        for line, command in parts:
            said = [line] if line else []
            done = subprocess.run(command, check=False, stdout=subprocess.PIPE, encoding="utf-8")
            if done.returncode:
                raise Failure(f"{os.path.basename(command[0])} ended with {done.returncode}: {' '.join(command)}")
            said += [text for text in done.stdout.splitlines() if not (without and text.startswith(without))]
            for text in said:
                file.write(text + "\n")
                print(text, flush=True)


FIGURES = {"rotor_kit": RotorKit()}
