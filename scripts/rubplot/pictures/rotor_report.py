"""The page of a rotor report: all its pictures and tables in one file that asks no other host for anything."""

import base64
import html
import os

from rubplot import captions, configuration, csv_table, gnuplot, report_tables, shown_units
from rubplot.failure import WrongCall
from rubplot.output import place_text
from rubplot.pictures import campbell, critical_map, deflected_shape, mode_shapes, rotor, stability, static_line
from rubplot.subcommand import Subcommand

# Pictures in the order of the page: title, what makes it, the table it is made of, the name of its remarks.
SECTIONS = (
    ("Rotor", rotor, "rotor_parts.csv", "rotor"),
    ("Static line", static_line, "static_line.csv", "static_line"),
    ("Campbell diagram", campbell, "campbell.csv", "campbell"),
    ("Undamped critical speed map", critical_map, "critical_map.csv", "critical_map"),
    ("Stability", stability, "campbell.csv", "stability"),
    ("Deflected shape", deflected_shape, "deflected_shape.csv", "deflected_shape"),
    ("Mode shapes", mode_shapes, "mode_shapes.csv", "mode_shapes"),
)
# Pictures that have their remarks inside.
SAID_INSIDE = ("stability", "deflected_shape")
STYLE = """body{font-family:'DejaVu Sans',Verdana,sans-serif;max-width:1400px;margin:2em auto;padding:0 1em;color:#222}
img{width:100%;height:auto}nav a{margin-right:1.2em}table{border-collapse:collapse;margin:1em 0}
td,th{padding:.2em .9em;border-bottom:1px solid #ccc;text-align:right}td:first-child,th:first-child{text-align:left}
.note{color:#555}.missing{background:#f6efdd;padding:.7em}@media print{nav{display:none}section{break-inside:avoid}}"""


def run(given):
    output = given.output or os.path.join(given.source, "rotor_report.html")
    if os.path.splitext(output)[1] != ".html" or os.path.isdir(output):
        raise WrongCall(f"--output {output}: allowed: a name that ends with .html")
    with shown_units.chosen(shown_units.Choice(given.speed_unit)):
        text = page(given)
    place_text(text, os.path.abspath(output))
    if not given.output:
        print(f"page: {os.path.relpath(output)}")


def page(given):
    """The page as a text."""
    notes = report_tables.notes(given.source)
    config = configuration.read_configuration(report_tables.path_of(given.source, "config.yaml"))
    heading = captions.headed(given.heading, config)
    sections = [section(given, *one, notes) for one in SECTIONS]
    links = "".join(f'<a href="#{name}">{html.escape(title)}</a>' for title, _, _, name in SECTIONS)
    remarks = "".join(f"<p>{html.escape(row['note'])}</p>" for row in notes.get("operating", []))
    byline = captions.byline(config)
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>{html.escape(heading)}</title>\n'
            f"<style>{STYLE}</style>\n</head>\n<body>\n<h1>{html.escape(heading)}</h1>\n"
            f"{f'<p>{html.escape(byline)}</p>' if byline else ''}{remarks}\n<nav>{links}</nav>\n" + "\n".join(sections) + "\n</body>\n</html>\n")


def section(given, title, module, table, name, notes):
    """One picture with its remarks and numbers, or what is missing and why."""
    missing = [row["note"] for row in notes.get(name, []) if row["note"].startswith("left out")]
    there = os.path.exists(os.path.join(given.source, table)) and not missing
    body = ""
    if there:
        body = f'<img alt="{html.escape(title)}" src="{embedded(module, given)}">'
        if name not in SAID_INSIDE:
            body += "".join(f'<p class="note">{html.escape(row["note"])}</p>' for row in notes.get(name, []))
        body += {"static_line": loads_table, "campbell": critical_table}.get(name, lambda _: "")(given.source)
    else:
        text = "; ".join(missing) or f"left out: there is no {table}"
        body = f'<p class="missing">{html.escape(title)}: {html.escape(text)}.</p>'
    return f'<section id="{name}">\n<h2>{html.escape(title)}</h2>\n{body}\n</section>'


def embedded(module, given):
    """A picture as an address that holds it."""
    settings = type("Given", (), {"source": given.source, "heading": module.SUBCOMMAND.heading})
    with gnuplot.drawing(module.picture(settings), ("png",)) as drawn, open(drawn["png"], "rb") as file:
        return "data:image/png;base64," + base64.b64encode(file.read()).decode("ascii")


def loads_table(directory):
    path = os.path.join(directory, "bearing_loads.csv")
    if not os.path.exists(path):
        return ""
    rows = [(row["bearing"], *("%.5g" % row[name] for name in ("position_m", "load_x_n", "load_y_n", "unbalance_force_n")))
            for row in report_tables.numbers(path, "position_m", "load_x_n", "load_y_n", "unbalance_force_n")]
    return _table(("bearing", "place (m)", "static load x (N)", "static load y (N)", "force by unbalance (N)"), rows)


def critical_table(directory):
    rows = []
    config = configuration.read_configuration(report_tables.path_of(directory, "config.yaml"))
    for row in csv_table.read_table(os.path.join(directory, "critical_speeds.csv"), "mode", "whirl", "speed_hz", "damping_ratio"):
        speed, ratio = csv_table.number(row, "speed_hz"), csv_table.number(row, "damping_ratio")
        rows.append((f"mode {row['mode']}", row["whirl"], shown_units.speed_text(config, speed), "%.4g" % ratio))
    if not rows:
        return '<p class="note">No critical speed in this range.</p>'
    return _table(("critical speed", "whirl", "speed", "damping ratio"), rows)


def _table(head, rows):
    line = "".join(f"<th>{html.escape(cell)}</th>" for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{line}</tr></thead><tbody>{body}</tbody></table>"


def options(parser):
    parser.add_argument("source", metavar="DIR")
    parser.add_argument("-o", "--output", metavar="FILE", help="a name that ends with .html (default: DIR/rotor_report.html)")
    parser.add_argument("--heading", metavar="TEXT", default="Rotor report", help="(default: '%(default)s')")


SUBCOMMAND = Subcommand(
    name="rotor-report",
    summary="the page of a rotor report, all pictures in one (rubtrace --rotor-report)",
    description="""Puts all pictures of what rubtrace --rotor-report wrote into DIR on one page of HTML, which holds them itself:
rotor, static line, Campbell diagram, critical speed map, stability, deflected shape and mode shapes.""",
    source="DIR",
    heading="Rotor report",
    run=run,
    options=options,
    units=("speed",),
    examples=("results/my_rotor", "results/my_rotor --output rotor.html --speed-unit rpm"),
)
