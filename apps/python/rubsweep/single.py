"""Programs that look at one cell, a line, a branch, a basin or a recording. Each function returns Results: a pandas
table for every file that the program writes, listed by its `--help`."""

import tempfile
from pathlib import Path
from typing import Any, Iterable, Mapping, Optional, Sequence, Tuple

from .configuration import Configuration, Path_, path_of
from .programs import call
from .results import Results, collect, place, read_all

Range = Tuple[float, float]


def trace(configuration: Configuration, *, speed_hz: Optional[float] = None, whirl_ratio: Optional[float] = None,
          eccentricity_m: Optional[float] = None, unbalance_g_mm: Optional[float] = None, revolutions: Optional[int] = None,
          options: Iterable[str] = (), output: Optional[Path_] = None, **overrides: Any) -> Results:
    """One motion from its kick (`rubtrace`): tables trajectory, section, spectrum, events, motion.

    speed_hz: shaft speed, of a trace; the unbalance is given by one of the next three. revolutions: number of turns from the kick.
    options: further options of the program, as ("--sample-s", "2e-4"); those of its experiments, as ("--free-response",)
    or ("--campbell", "10:100"), go without a speed.
    """
    arguments = [*unbalance(whirl_ratio, eccentricity_m, unbalance_g_mm), *options]
    if speed_hz is not None:
        arguments += ["--speed-hz", repr(float(speed_hz))]
    if revolutions is not None:
        arguments += ["--revolutions", str(revolutions)]
    return collect("rubtrace", configuration, arguments, overrides, output, None)


def line(configuration: Configuration, along: str, values: Optional[Range] = None, count: int = 101, *,
         passes: Sequence[str] = ("kick",), speed_hz: Optional[float] = None, whirl_ratio: Optional[float] = None,
         eccentricity_m: Optional[float] = None, unbalance_g_mm: Optional[float] = None, threads: int = 0,
         output: Optional[Path_] = None, progress: Optional[bool] = None, **overrides: Any) -> Results:
    """Motions along one parameter (`rubline`): tables line, bifurcation, cascade.

    along: `speed_hz`, `whirl_ratio`, `eccentricity_m` or the path of a number of the configuration. values: first and last
    of `count` even ones, in its unit; those of the sweep unless given. passes: of `kick`, `up`, `down`.
    """
    options = ["--along", along, "--threads", str(threads), *(f"--{name}" for name in passes)]
    options += unbalance(whirl_ratio, eccentricity_m, unbalance_g_mm)
    if speed_hz is not None:
        options += ["--speed-hz", repr(float(speed_hz))]
    if values is not None:
        options += ["--from", repr(float(values[0])), "--to", repr(float(values[1])), "--count", str(count)]
    return collect("rubline", configuration, options, overrides, output, progress)


def branch(configuration: Configuration, cell: Tuple[float, float], along: str = "speed_hz", values: Optional[Range] = None, *,
           switch: bool = False, curve: Optional[str] = None, output: Optional[Path_] = None, **overrides: Any) -> Results:
    """The orbit of a cell followed along a parameter, stable or not (`rubbranch`): tables branch, events, with `curve` (a
    second parameter) also curves, meetings.

    cell: speed in Hz and unbalance as the sweep has it. switch: follow the doubled orbit at period doublings, too.
    """
    options = ["--cell", pair(cell), "--along", along, *(["--switch"] if switch else [])]
    if values is not None:
        options += ["--from", repr(float(values[0])), "--to", repr(float(values[1]))]
    if curve is not None:
        options += ["--curve", curve]
    return collect("rubbranch", configuration, options, overrides, output, None)


def basin(configuration: Configuration, cell: Tuple[float, float], plane: Optional[Tuple[str, str]] = None,
          grid: Tuple[int, int] = (65, 65), *, first: Optional[Range] = None, last: Optional[Range] = None, threads: int = 0,
          output: Optional[Path_] = None, progress: Optional[bool] = None, **overrides: Any) -> Results:
    """Motions that coexist in a cell, and the starts that lead to each (`rubbasin`): tables slice, attractors, map.

    plane: the two numbers of a start that vary, as x and vx. first, last: corners of the grid, in m, m/s or the keys' units.
    """
    options = ["--cell", pair(cell), "--grid", f"{grid[0]}x{grid[1]}", "--threads", str(threads)]
    for name, corner in (("--from", first), ("--to", last)):
        if corner is not None:
            options.append(f"{name}={pair(corner)}")
    if plane is not None:
        options += ["--plane", ",".join(plane)]
    return collect("rubbasin", configuration, options, overrides, output, progress)


def scope(recording: Path_, *, instrument: Optional[Configuration] = None, options: Iterable[str] = (),
          output: Optional[Path_] = None) -> Results:
    """Says what a recorded motion is (`rubscope`): tables turns, orbit, lines, bode, waterfall, measures; the verdict is
    in `text`.

    recording: CSV, WAV or MATLAB file. instrument: its probes, keyphasor and clock, a path or a dict; unless given the file
    of the same name with the ending .yaml.
    """
    return of_recording("rubscope", recording, {"--instrument": instrument}, options, output, None)


def diagnose(recording: Path_, machine: Configuration, *, candidates: Optional[Configuration] = None,
             instrument: Optional[Configuration] = None, options: Iterable[str] = (), output: Optional[Path_] = None,
             progress: Optional[bool] = None) -> Results:
    """Which rub a recording shows, if any (`rubdiagnose`): tables probabilities, orbits, lines; the answer is in `text`.

    machine: the configuration of the rotor. candidates: what is asked about; the usual list unless given.
    """
    given = {"--machine": machine, "--candidates": candidates, "--instrument": instrument}
    return of_recording("rubdiagnose", recording, given, options, output, progress)


def fit(configuration: Configuration, find: Iterable[str], *, ring_downs: Iterable[Path_] = (), run_ups: Iterable[Path_] = (),
        steady: Iterable[Path_] = (), ramps: Iterable[Path_] = (), rubs: Iterable[Path_] = (), options: Iterable[str] = (),
        output: Optional[Path_] = None, **overrides: Any) -> Results:
    """Numbers of a machine from what was measured (`rubfit`): tables parameters (with 95 % intervals), correlation and
    others.

    find: keys, each as `key` or `key=low:high`. The other lists are files of each kind of measurement; `options` are
    further options of the program, as ("--mark-deg", "30").
    """
    arguments = [text for key in find for text in ("--fit", key)]
    for option, files in (("--ring-down", ring_downs), ("--run-up", run_ups), ("--steady", steady), ("--ramp", ramps),
                          ("--rub", rubs)):
        arguments += [text for file in files for text in (option, str(file))]
    return collect("rubfit", configuration, [*arguments, *options], overrides, output, None)


def of_recording(program: str, recording: Path_, files: Mapping[str, Optional[Configuration]], options: Iterable[str],
                 output: Optional[Path_], progress: Optional[bool]) -> Results:
    with tempfile.TemporaryDirectory(prefix="rubsweep-") as directory, place(output) as written:
        arguments = [str(recording), *options, "--output", str(written)]
        for option, file in files.items():
            if file is not None:
                own = Path(directory) / option.strip("-")
                own.mkdir()
                arguments += [option, path_of(file, str(own))]
        return read_all(call(program, arguments, progress), output)


def pair(values: Range) -> str:
    return ",".join(repr(float(value)) for value in values)


def unbalance(whirl_ratio: Optional[float], eccentricity_m: Optional[float], unbalance_g_mm: Optional[float]) -> "list[str]":
    named = (("--whirl-ratio", whirl_ratio), ("--eccentricity-m", eccentricity_m), ("--unbalance-g-mm", unbalance_g_mm))
    return [text for option, value in named if value is not None for text in (option, repr(float(value)))]
