"""The rotor as its file has it: layers, discs, bearings, seals, stops and probes along the shaft, by their names."""

import math

from rubplot import captions, configuration, gnuplot_text, lanes, report_tables
from rubplot.gnuplot import Picture
from rubplot.subcommand import Subcommand

STEEL = 7850.0  # kg/m3
LETTER = 0.0064  # width of a letter as a share of the axis
ROW = 0.062  # height of a row of labels, as a share of the picture
MOST_NAMED = 16  # more parts of one kind than these have no names
ABOVE, BELOW = ("disc", "point_mass", "probe", "stop"), ("bearing", "seal", "coupling", "load")
# Column 3 of the file "parts": number of a kind in the legend.
KINDS = ("bearing", "seal", "stop", "probe", "point_mass", "coupling", "load")
COLOURS = ("#88CCEE", "#44AA99", "#DDCC77", "#CC6677")
SIZES = ("position_m", "end_m", "inner_m", "outer_m", "inner_end_m", "outer_end_m", "mass_kg", "polar_inertia_kg_m2")


def picture(given):
    path = report_tables.require(given.source, "rotor_parts.csv", "rotor")
    parts = report_tables.numbers(path, *SIZES)
    config = configuration.read_configuration(report_tables.path_of(given.source, "config.yaml"))
    layers = [part for part in parts if part["element"] == "layer"]
    length = max(part["end_m"] for part in parts if part["end_m"] is not None)
    discs = [{**part, **size_of(part, length)} for part in parts if part["element"] == "disc"]
    radius = max([largest_m(layers) / 2, *(disc["radius_m"] for disc in discs)], default=0) or 0.1 * length
    above, below = (lanes.lay_out(named(parts, kinds, length), LETTER) for kinds in (ABOVE, BELOW))
    low, high = 0.05 + ROW * lanes.rows(below), 0.95 - ROW * lanes.rows(above)
    # Radii from -1.25 to 1.25 of the largest one between the labels.
    per_share = 2.5 * radius / max(high - low, 0.1)
    bottom = -1.25 * radius - low * per_share
    return Picture(
        "rotor.gp",
        (captions.headed(given.heading, config), captions.byline(config)),
        {
            "parts": part_lines(parts, layers, radius),
            "labels.gp": [
                f"length = {1e3 * length:.17g}",
                f"bottom = {1e3 * bottom:.17g}",
                f"top = {1e3 * (bottom + per_share):.17g}",
                f"radius = {1e3 * radius:.17g}",
                f"any_layers = {len(layers) > 0:d}",
                *(f"any_{kind} = {any(part['element'] == kind for part in parts):d}" for kind in (*KINDS, "disc")),
                *shape_lines(layers, discs),
                *label_lines(above, length, over(layers, discs, radius), lambda row: high + ROW * (row + 0.5), 1),
                *label_lines(below, length, over(layers, discs, radius), lambda row: low - ROW * (row + 0.5), -1),
            ],
        },
    )



def size_of(disc, length_m):
    """Radius and half width of a disc of steel with this mass and polar inertia, as the file tells neither."""
    mass, inertia = disc["mass_kg"] or 0, disc["polar_inertia_kg_m2"] or 0
    if mass <= 0 or inertia <= 0:
        return {"radius_m": 0.0, "half_width_m": 0.004 * length_m}
    radius = math.sqrt(2 * inertia / mass)
    return {"radius_m": radius, "half_width_m": min(mass / (STEEL * math.pi * radius**2), 0.06 * length_m) / 2}


def largest_m(layers):
    """The largest outer diameter; 0 without layers."""
    return max((max(layer["outer_m"], layer["outer_end_m"]) for layer in layers), default=0)


def named(parts, kinds, length_m):
    """(share of the length, name) of the parts of these kinds, without kinds that have too many parts."""
    found = []
    for kind in kinds:
        of_kind = [part for part in parts if part["element"] == kind]
        if len({part["position_m"] for part in of_kind}) <= MOST_NAMED:
            found += [(part["position_m"] / length_m, part["name"]) for part in of_kind]
    return found


def surface_m(layers, position_m):
    """Outer radius of the shaft at a place; 0 where the file does not tell it."""
    radii = [0.0]
    for layer in layers:
        begin, end = layer["position_m"], layer["end_m"]
        if begin - 1e-9 <= position_m <= end + 1e-9:
            share = (position_m - begin) / (end - begin)
            radii.append((layer["outer_m"] + share * (layer["outer_end_m"] - layer["outer_m"])) / 2)
    return max(radii)


def over(layers, discs, radius_m):
    """A function from a place to the radius just above all that is there."""
    def height(position_m):
        at_discs = [disc["radius_m"] for disc in discs if abs(disc["position_m"] - position_m) <= disc["half_width_m"]]
        return max([surface_m(layers, position_m), *at_discs]) + 0.2 * radius_m

    return height


def part_lines(parts, layers, radius_m):
    """Place in mm, radius of the shaft there in mm, and the number of the kind; one beside the picture in any case."""
    yield "-1e9 0 -1"
    for part in parts:
        if part["element"] in KINDS:
            at = surface_m(layers, part["position_m"])
            yield "%.17g %.17g %d" % (1e3 * part["position_m"], 1e3 * at, KINDS.index(part["element"]))


def shape_lines(layers, discs):
    """Layers and discs as gnuplot's polygons, both halves of the section."""
    materials = {}
    count = 0
    for layer in layers:
        colour = COLOURS[materials.setdefault(" layer " in layer["name"], len(materials)) % len(COLOURS)]
        corners = ((layer["position_m"], layer["inner_m"]), (layer["end_m"], layer["inner_end_m"]), (layer["end_m"], layer["outer_end_m"]),
                   (layer["position_m"], layer["outer_m"]))
        for side in (0.5, -0.5):
            count += 1
            yield _polygon(count, [(z, side * d) for z, d in corners], colour, 0.75)
    for disc in discs:
        z, half, radius = disc["position_m"], disc["half_width_m"], disc["radius_m"]
        count += 1
        yield _polygon(count, [(z - half, -radius), (z + half, -radius), (z + half, radius), (z - half, radius)], "#CC6677", 0.45)


def _polygon(number, corners, colour, solid):
    points = " to ".join("first %.17g, first %.17g" % (1e3 * z, 1e3 * r) for z, r in [*corners, corners[0]])
    return f"set object {number} polygon from {points} fillcolor rgb '{colour}' fillstyle solid {solid} border linecolor rgb '#555555'"


def label_lines(labels, length_m, surface, height, side):
    """Names in their rows, and a line from each to its part, as gnuplot's labels and arrows."""
    for label in labels:
        x, middle, y = 1e3 * length_m * label.at, label.middle, height(label.row)
        yield (f"set arrow from first {x:.17g}, first {1e3 * side * surface(length_m * label.at):.17g} to "
               f"graph {SPAN[0] + SPAN[1] * middle:.17g}, graph {y - side * 0.02:.17g} nohead linewidth 0.7 linecolor rgb '#AAAAAA' back")
        yield (f"set label {gnuplot_text.quoted(label.text)} at graph {SPAN[0] + SPAN[1] * middle:.17g}, graph {y:.17g} center "
               "noenhanced front font ',15' boxed")


# Begin and width of the shaft as shares of the axis, whose ends lie beyond those of the shaft.
SPAN = (0.04 / 1.08, 1 / 1.08)

SUBCOMMAND = Subcommand(
    name="rotor",
    summary="the rotor of a report as its file has it (rubtrace --rotor-report)",
    description="""Draws the rotor from what rubtrace --rotor-report wrote into DIR: layers of the shaft, discs, bearings and
seals by their names, stops and probes. Discs are drawn as steel of their mass and polar inertia.""",
    source="DIR",
    heading="Rotor",
    picture=picture,
    examples=("results/my_rotor", "results/my_rotor --output rotor.pdf"),
)
