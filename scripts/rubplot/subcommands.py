"""All subcommands, in the order of the help."""

from rubplot.pictures import (
    basin,
    bode,
    branch,
    calibration,
    campbell,
    cascade,
    compare,
    critical_map,
    curves,
    deflected_shape,
    design,
    diagnosis,
    fit,
    identification,
    line,
    map,
    mode_shapes,
    ring,
    ring_chart,
    rotor,
    rotor_report,
    run_up,
    scope,
    stability,
    static_line,
    threshold,
    trace,
    work_precision,
)
from rubplot.published import figure

ALL = tuple(
    module.SUBCOMMAND
    for module in (map, threshold, compare, trace, line, cascade, branch, curves, basin, run_up, bode, campbell, design, rotor_report, rotor,
                   static_line, critical_map, stability, deflected_shape, mode_shapes,
                   identification, scope, fit, diagnosis, calibration, ring, ring_chart, work_precision, figure)
)
