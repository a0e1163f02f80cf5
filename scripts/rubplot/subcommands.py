"""All subcommands, in the order of the help."""

from rubplot.pictures import (
    basin,
    bode,
    branch,
    calibration,
    campbell,
    cascade,
    compare,
    curves,
    design,
    diagnosis,
    fit,
    identification,
    line,
    map,
    ring,
    ring_chart,
    run_up,
    scope,
    threshold,
    trace,
    work_precision,
)
from rubplot.published import figure

ALL = tuple(
    module.SUBCOMMAND
    for module in (map, threshold, compare, trace, line, cascade, branch, curves, basin, run_up, bode, campbell, design,
                   identification, scope, fit, diagnosis, calibration, ring, ring_chart, work_precision, figure)
)
