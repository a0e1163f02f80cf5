"""mark_schemas.py CONFIGS RUBSWEEP RINGSTAB: writes the schemas that the programs print to CONFIGS/schema, and as the first line
of every configuration below CONFIGS the one by which an editor finds its schema."""

import os
import subprocess
import sys

MARK = "# yaml-language-server: $schema="


def schema_of(path):
    """Name of the schema of a configuration by its file; empty for a part of others, and for those of rubdata and rubdiagnose."""
    folder = os.path.basename(os.path.dirname(path))
    if os.path.basename(path) == "stop.yaml" or folder == "recordings":
        return ""
    of_ring = folder == "ring" or os.path.basename(path).startswith("ring_")
    return "ringstab.schema.json" if of_ring else "rubsweep.schema.json"


def marked(text, line):
    """A configuration with this line at its head, in place of another such."""
    rest = text.split("\n", 1)[1] if text.startswith(MARK) else text
    return f"{line}\n{rest}"


def line_of(path, configs):
    """The line of a configuration in the folder `configs` or below it, with a path that is relative to the file."""
    schema = os.path.join(configs, "schema", schema_of(path))
    return MARK + os.path.relpath(schema, os.path.dirname(path))


def configurations(configs):
    """Files below a folder that have a schema."""
    for folder, _, names in sorted(os.walk(configs)):
        for name in sorted(names):
            path = os.path.join(folder, name)
            if name.endswith(".yaml") and schema_of(path):
                yield path


def main(arguments):
    configs, *programs = arguments
    os.makedirs(os.path.join(configs, "schema"), exist_ok=True)
    for program in programs:
        asked = subprocess.run([program, "--schema"], check=True, capture_output=True, text=True)
        path = os.path.join(configs, "schema", os.path.basename(program) + ".schema.json")
        with open(path, "w", encoding="utf-8") as file:
            file.write(asked.stdout)
    for path in configurations(configs):
        with open(path, encoding="utf-8") as file:
            text = file.read()
        with open(path, "w", encoding="utf-8") as file:
            file.write(marked(text, line_of(path, configs)))


if __name__ == "__main__":
    main(sys.argv[1:])
