"""The program behind domain_map.sh, which says what it does."""

import os
import tempfile

import configuration
import csv_table
import domain_map
import gnuplot
import map_heading
import refined_map
import shown_units
import swept_axes
from command import Failure, require_readable, run_program


def label(axis):
    """What stands at an axis; keys of the configuration under their own names."""
    return axis.label.replace("_", r"\_")


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    map_file, output = (os.path.abspath(name) for name in arguments[:2])
    config_file = os.path.join(os.path.dirname(map_file), "config.yaml")
    require_readable(map_file, config_file)
    config = configuration.read_configuration(config_file)

    identified_hz = os.environ.get("NATURAL_FREQUENCY_HZ") or None
    if identified_hz is not None:
        identified_hz = configuration.number(identified_hz)
    natural_hz = identified_hz
    if "rotor.natural_frequency_hz" in config:
        natural_hz = configuration.number(config["rotor.natural_frequency_hz"])
    across, up = swept_axes.plane(config)
    if across != "speed_hz" or shown_units.in_rpm(config):
        natural_hz = None

    fade = len(arguments) > 3
    if fade and arguments[3] != "fade":
        raise Failure(f"'{arguments[3]}' is not allowed, allowed: fade")
    if fade and config.get("response.robustness") != "probability":
        raise Failure(f"{map_file} has no column robust_share: response.robustness is not probability")
    cells = domain_map.read_cells(map_file, up, natural_hz, across, "robust_share" if fade else None)
    boundaries = {}
    if across == "speed_hz":
        boundary_file = os.path.join(os.path.dirname(map_file), "boundaries.csv")
        boundaries = domain_map.read_boundaries(boundary_file, up, natural_hz, csv_table.digest(map_file))
    if "sweep.refine.levels" in config:
        columns = [swept_axes.values(config, axis) for axis in (across, up)]
        cells = refined_map.painted_cells(cells, *columns, int(config["sweep.refine.levels"]))
    axes = [shown_units.axis(config, across), shown_units.axis(config, up, max(cell.y for cell in cells))]
    if natural_hz is not None:
        axes[0] = shown_units.Axis("shaft speed / natural frequency", 1, axes[0].logarithmic)
    cells, boundaries = domain_map.scaled(cells, boundaries, axes[0].factor, axes[1].factor)
    logarithmic = [axis.logarithmic and min(values) > 0
                   for axis, values in zip(axes, ([cell.x for cell in cells], [cell.y for cell in cells]))]
    present = " ".join(sorted({cell.kind for cell in cells}))
    os.makedirs(os.path.dirname(output), exist_ok=True)
    with tempfile.NamedTemporaryFile("w", encoding="utf-8") as file:
        file.writelines(line + "\n" for line in domain_map.cell_lines(cells, logarithmic))
        file.writelines(line + "\n" for line in domain_map.boundary_lines(boundaries))
        file.flush()
        gnuplot.draw(
            "domain_map.gp",
            file.name,
            output,
            map_heading.heading(arguments[2], config, identified_hz),
            f" {present} ",
            domain_map.label_text(domain_map.labels(cells)),
            label(axes[0]),
            label(axes[1]),
            " ".join(boundaries),
            " ".join(word for word, on in zip(("fade", "logx", "logy"), (fade, *logarithmic)) if on),
        )


if __name__ == "__main__":
    run_program(main, usage="domain_map.sh MAP.csv OUTPUT_BASENAME HEADING [fade]", least=3, most=4)
