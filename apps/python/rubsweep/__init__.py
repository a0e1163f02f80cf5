"""rubsweep from Python: maps of where a rotor's rub persists, single motions, branches, basins, recordings.

    import rubsweep
    rub = rubsweep.run("configs/minimal.yaml", **{"sweep.speed_hz.count": 20})
    rub["peak_displacement_m"].sel(whirl_ratio=0.4)
    rubsweep.plot(rub)

Every function writes its configuration (a path or a dict), runs the program of the same purpose, and reads what it
wrote: a map as an xarray Dataset with units in its attributes, everything else as pandas tables. Numbers are SI, with
the unit in each name. Bad input raises `BadInput`, which carries file, line, key and what is allowed; Ctrl-C interrupts
the program, and with `output=` the next call goes on where it was. The programs are looked for in the directory that
the environment variable RUBSWEEP_PROGRAMS names, else on the PATH.
"""

from .errors import BadInput, Problem, RubsweepError
from .figures import plot
from .maps import cells, read_map, run
from .results import Results
from .ross import from_ross
from .single import basin, branch, diagnose, fit, line, scope, trace
from .tables import read_table, unit_of

__all__ = ["BadInput", "Problem", "Results", "RubsweepError", "basin", "branch", "cells", "diagnose", "fit", "from_ross",
           "line", "plot", "read_map", "read_table", "run", "scope", "trace", "unit_of"]
