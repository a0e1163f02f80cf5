"""Onsets of loads on an elastic ring over the parameter of a chart."""

import os
from dataclasses import dataclass

from rubplot import captions, configuration, csv_table
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

KINDS = tuple(f"{kind}_{end}" for kind in ("coupling", "divergence", "flutter") for end in ("begin", "end"))


@dataclass(frozen=True)
class Chart:
    """The onsets of chart_onsets.csv: lines (parameter, rpm) by kind, the parameters at which growing roots merge, so that two loads
    couple, and all parameters."""

    parameter: str
    by_kind: dict
    couplings: list


def read_chart(directory):
    by_kind = {kind: [] for kind in KINDS}
    couplings, name = set(), ""
    for row in csv_table.read_table(os.path.join(directory, "chart_onsets.csv"), "kind", "speed_rpm", "note"):
        # The first column is named after the parameter of the chart.
        name, parameter = next(iter(row.items()))
        if row["kind"] in by_kind:
            by_kind[row["kind"]].append(f"{parameter} {row['speed_rpm']}")
        if row["kind"] == "real_merger" and "growing" in row["note"]:
            couplings.add(csv_table.number(row, name))
    return Chart(name, by_kind, sorted(couplings))


def picture_of(chart, heading, parameters, top_rpm="*", byline=""):
    """`parameters`: the ends of the axis across, as gnuplot reads them; so is the end of the axis of speeds."""
    label = {"inclination_deg": "inclination (°)", "angle_deg": "angle (°)"}.get(chart.parameter, chart.parameter)
    files = {kind: lines or ["NaN NaN"] for kind, lines in chart.by_kind.items()}
    return Picture("ring_chart.gp", (heading, label, *parameters, top_rpm, byline), files)


def picture(given):
    chart = read_chart(given.source)
    config = configuration.read_configuration(os.path.join(given.source, "config.yaml"))
    values = configuration.axis(config, "chart.over")
    ends = ("%.17g" % min(values), "%.17g" % max(values)) if values else ("*", "*")
    return picture_of(chart, captions.headed(given.heading, config), ends, byline=captions.byline(config))


SUBCOMMAND = Subcommand(
    name="ring-chart",
    summary="onsets over the parameter of a stability chart (ringstab)",
    description="""Draws the chart that ringstab wrote into DIR: the speeds at which coupling, divergence and flutter begin and
end, over the parameter of the chart.""",
    source="DIR",
    heading="Onsets of instability",
    picture=picture,
    examples=("results/ring_figure20", "results/ring_figure15 --output chart.pdf"),
)
