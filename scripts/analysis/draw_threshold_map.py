"""The program behind threshold_map.sh, which says what it does."""

import os
import tempfile

import configuration
import gnuplot
import map_heading
import shown_units
import swept_axes
import threshold_map
from command import require_readable, run_program
from draw_domain_map import label


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    map_file, output = (os.path.abspath(name) for name in arguments[:2])
    config_file = os.path.join(os.path.dirname(map_file), "config.yaml")
    require_readable(map_file, config_file)
    config = configuration.read_configuration(config_file)
    across, up = swept_axes.plane(config)
    natural_hz = None
    if across == "speed_hz" and not shown_units.in_rpm(config) and "rotor.natural_frequency_hz" in config:
        natural_hz = configuration.number(config["rotor.natural_frequency_hz"])
    cells = threshold_map.read_cells(map_file, across, up, natural_hz)
    axes = [shown_units.axis(config, across), shown_units.axis(config, up, max(y for _, y, _ in cells))]
    if natural_hz is not None:
        axes[0] = shown_units.Axis("shaft speed / natural frequency")
    cells = [(axes[0].factor * x, axes[1].factor * y, threshold) for x, y, threshold in cells]
    key = config.get("study.key") or config.get("study.keys", "threshold")
    os.makedirs(os.path.dirname(output), exist_ok=True)
    with tempfile.NamedTemporaryFile("w", encoding="utf-8") as file:
        file.writelines(line + "\n" for line in threshold_map.box_lines(cells))
        file.write("\n\n")  # gnuplot's next index
        file.writelines(line + "\n" for line in threshold_map.grid_lines(cells))
        file.flush()
        gnuplot.draw(
            "threshold_map.gp",
            file.name,
            output,
            map_heading.heading(arguments[2], config),
            label(axes[0]),
            label(axes[1]),
            key.replace("_", r"\_"),
            ",".join("%.17g" % level for level in threshold_map.levels(cells)),
        )


if __name__ == "__main__":
    run_program(main, usage="threshold_map.sh MAP.csv OUTPUT_BASENAME HEADING", least=3, most=3)
