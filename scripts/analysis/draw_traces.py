"""The program behind trace.sh, which says what it does."""

import os
import re
import tempfile

import captions
import configuration
import gnuplot
import trace_layout
from command import run_program


def main(arguments):
    # Absolute names: to gnuplot others may be commands.
    output = os.path.abspath(arguments[1])
    heading = arguments[2]
    revolutions = trace_layout.checked("REVOLUTIONS", (arguments[3:4] or ["40"])[0], re.compile(r"-?(0|[1-9][0-9]*)"))
    traces = [os.path.abspath(name) for name in [arguments[0]] + arguments[4:]]
    with tempfile.TemporaryDirectory() as work:
        rows = [trace_layout.lay_out(trace, work, i + 1, int(revolutions)) for i, trace in enumerate(traces)]
        highest = max(row["highest"] for row in rows)
        for i, row in enumerate(rows):
            trace_layout.lay_out_labels(work, i + 1, row, highest)
        with open(os.path.join(work, "rows.gp"), "w", encoding="utf-8") as file:
            for array in rows[0]:
                file.write(f"array {array}[{len(rows)}]\n")
                file.writelines(f"{array}[{i + 1}] = {row[array]}\n" for i, row in enumerate(rows))
        config = configuration.read_configuration(os.path.join(traces[0], "config.yaml"))
        os.makedirs(os.path.dirname(output), exist_ok=True)
        gnuplot.draw("trace.gp", work, output, captions.headed(heading, config), str(len(rows)), captions.byline(config))


if __name__ == "__main__":
    run_program(main, usage="trace.sh TRACE_DIR OUTPUT_BASENAME HEADING [REVOLUTIONS [TRACE_DIR]...]", least=3)
