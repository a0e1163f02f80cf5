"""A design check: unbalance response at probes and stops, kicks over the speed, and what each check says."""

import os
import re
from itertools import groupby

from rubplot import captions, configuration, csv_table, gnuplot_text, shown_units
from rubplot.failure import require_readable
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

MOST_CURVES = 8  # of probes and of stops each
MOST_ROWS = 14
MOST_LETTERS = ((2, 32), (5, 12))  # of a name in a legend of at most so many curves; of more curves there are numbers only
PLACES = r"(?:(?:configured|mode [12]|left end|right end) at )?(?:probe|stop|support) \d+"
CHECKS = {"vibration": "vibration", "clearance": "clearance", "dry_whip": "dry whip", "stability": "stability",
          "clearance_to_trip": "to trip", "response": "response", "separation": "separation", "amplification": "AF",
          "bearing_force": "force", "cross_coupling": "coupling", "level_1": "level I", "level_1_threshold": "Q0 / QA",
          "level_1_region": "region",
          "level_2": "level II", "kick": "smallest kick"}
OF_NO_PLACE = ("kick", "stability", "clearance_to_trip", "separation", "cross_coupling", "level_1", "level_1_threshold", "level_1_region",
               "level_2")


def picture(given):
    directory = given.source
    names = ("design_check.csv", "unbalance_response.csv", "lock_speeds.csv", "config.yaml")
    files = {name: os.path.join(directory, name) for name in names}
    require_readable(*files.values())
    config = configuration.read_configuration(files["config.yaml"])
    speed = shown_units.axis(config, "speed_hz")
    probes, stops = curves(files["unbalance_response.csv"])
    locks = [csv_table.number(row, "speed_hz") for row in csv_table.read_table(files["lock_speeds.csv"], "speed_hz")]
    kicks = kick_rows(os.path.join(directory, "kicks.csv"))
    checks = check_rows(files["design_check.csv"])
    names = names_of(files["design_check.csv"])
    limits = [row[2] for _, rows in probes for row in rows if row[2] is not None]
    return Picture(
        "design.gp",
        (captions.headed(given.heading, config), str(len(probes)), str(len(stops)), captions.byline(config), speed.label),
        {
            **{f"probe_{i}": response_lines(rows, speed.factor, 1e6) for i, (_, rows) in enumerate(probes)},
            **{f"stop_{i}": share_lines(rows, speed.factor) for i, (_, rows) in enumerate(stops)},
            "limit": limit_lines(probes[0][1] if probes else [], speed.factor),
            "kicks": kick_lines(kicks, speed.factor),
            "quiet": mark_lines([hz for hz, force in kicks if force is None], speed.factor),
            "locks": mark_lines(dict.fromkeys(locks), speed.factor),
            "labels.gp": [
                *(f"probe_name_{i} = {gnuplot_text.quoted(text)}" for i, text in enumerate(named(probes, names))),
                *(f"stop_name_{i} = {gnuplot_text.quoted(text)}" for i, text in enumerate(named(stops, names))),
                f"limit = {1e6 * limits[0] if limits else 0:.17g}",
                f"top_share = {top_share(stops):.17g}",
                f"any_kicks = {any(force is not None for _, force in kicks):d}",
                f"any_quiet = {any(force is None for _, force in kicks):d}",
                f"any_locks = {len(locks) > 0:d}",
                *text_lines(checks, config),
            ],
        },
    )


def curves(path):
    """The curves of probes and of stops, each its place and its rows (speed_hz, major_axis_m, limit_m or None)."""
    rows = csv_table.read_table(path, "place", "position_m", "speed_hz", "major_axis_m", "limit_m")
    found = {"probe": [], "stop": []}
    for place, of_place in groupby(rows, key=lambda row: row["place"]):
        _require_place(path, place)
        numbers = [tuple(csv_table.number(row, name) for name in ("speed_hz", "major_axis_m", "limit_m")) for row in of_place]
        found[place.split(" ")[0]].append((place, numbers))
    return found["probe"][:MOST_CURVES], found["stop"][:MOST_CURVES]


def names_of(path):
    """The name of each place that has one; tables of earlier versions have no names."""
    return {row["place"]: row["name"] for row in csv_table.read_table(path, "check", "place")
            if row["check"] in ("vibration", "clearance") and row.get("name")}


def named(curves_of_kind, names):
    """`probe 0 (drive end x)` for each curve, so short that the legend stays above its panel."""
    most = next((letters for curves, letters in MOST_LETTERS if len(curves_of_kind) <= curves), 0)
    return [f"{place} ({shortened(names[place], most)})" if most and place in names else place for place, _ in curves_of_kind]


def shortened(name, most):
    return name if len(name) <= most else name[:most - 1] + "…"


def check_rows(path):
    """The rows of the checks; of each place and kind that there is."""
    rows = list(csv_table.read_table(path, "check", "place", "speed_hz", "value", "margin", "verdict"))
    for row in rows:
        if row["check"] not in CHECKS:
            raise csv_table.TableError(f"{path}: '{row['check']}' is no check")
        if row["check"] not in OF_NO_PLACE or row["place"]:
            _require_place(path, row["place"], PLACES)
    return shown_rows(rows)


def shown_rows(rows):
    """All rows where there is room for them; else those that are not met, and then the smallest margins."""
    if len(rows) <= MOST_ROWS:
        return rows
    kept = [row for row in rows if row["verdict"] or row["check"] == "kick"]
    order = {"not_met": 0, "not_told": 1}
    margins = {id(row): csv_table.number(row, "margin") for row in kept}
    kept.sort(key=lambda row: (order.get(row["verdict"], 2), 1e9 if margins[id(row)] is None else margins[id(row)]))
    return kept[:MOST_ROWS]


def _require_place(path, place, places=r"(probe|stop) \d+"):
    if not re.fullmatch(places, place):
        raise csv_table.TableError(f"{path}: '{place}' is no place")


def kick_rows(path):
    """Speed and smallest force, None where no kick starts a rub; nothing where no kicks were tried."""
    if not os.path.exists(path):
        return []
    return [(csv_table.number(row, "speed_hz"), csv_table.number(row, "force_n"))
            for row in csv_table.read_table(path, "speed_hz", "force_n")]


def response_lines(rows, per_hz, per_metre):
    return ("%.17g %.17g" % (per_hz * hz, per_metre * axis) for hz, axis, _ in rows)


def share_lines(rows, per_hz):
    """The axis as a share of its limit in per cent; nothing where the rotor rests on the stop."""
    return ("%.17g %.17g" % (per_hz * hz, 100 * axis / limit) for hz, axis, limit in rows if limit)


def top_share(stops):
    """The end of the axis of the shares, in per cent: above the limit, so that it is seen."""
    shares = [100 * axis / limit for _, rows in stops for _, axis, limit in rows if limit]
    return max(200, *(1.5 * share for share in shares)) if shares else 200


def limit_lines(rows, per_hz):
    """The limit of the probes where there is one: over the operating range."""
    return ("%.17g %.17g" % (per_hz * hz, 1e6 * limit) for hz, _, limit in rows if limit is not None)


def kick_lines(kicks, per_hz):
    """A block for each stretch of speeds at which some kick starts a rub."""
    for hz, force in kicks:
        yield "" if force is None else "%.17g %.17g" % (per_hz * hz, force)


def mark_lines(speeds, per_hz):
    """Marks on the axis of speeds; one below the picture where there is none, as gnuplot warns of empty files."""
    return ["%.17g 0" % (per_hz * hz) for hz in speeds] or ["0 -1"]


def text_lines(checks, config):
    """The table of the checks as gnuplot's labels, the columns below each other."""
    for number, row in enumerate([None, *checks[:MOST_ROWS]]):
        cells = ("check", "where", "speed", "margin", "") if row is None else check_cells(row, config)
        colour = "#AA3311" if row is not None and row["verdict"] == "not_met" else "black"
        for column, cell in zip((0.53, 0.61, 0.73, 0.868, 0.94), cells):
            yield (f"set label '{cell}' at screen {column}, {0.405 - 0.0245 * number:.4f} left noenhanced "
                   f"font '{':Bold' if row is None else ''},17' textcolor rgb '{colour}'")


def check_cells(row, config):
    """One check in the table: name, place, speed, margin or value, verdict."""
    speed, margin = csv_table.number(row, "speed_hz"), csv_table.number(row, "margin")
    if row["check"] == "kick":
        margin_text = "%.4g N" % csv_table.number(row, "value")
    else:
        margin_text = "" if margin is None else "%.1f %%" % (100 * margin)
    return (CHECKS[row["check"]], row["place"].replace(" at probe", ", probe"), "" if speed is None else shown_units.speed_text(config, speed),
            margin_text, {"ok": "ok", "not_met": "not met", "not_told": "not told"}.get(row["verdict"], ""))


SUBCOMMAND = Subcommand(
    name="design",
    summary="a design check (rubtrace --design-check)",
    description="""Draws what rubtrace --design-check wrote into DIR: the scaled unbalance response at the probes and at
the stops, the smallest kicks that start a lasting rub, lock speeds, and the margin of each check.""",
    source="DIR",
    heading="Design check",
    picture=picture,
    units=("speed",),
    examples=("results/my_design", "results/my_design --output design.pdf"),
)
