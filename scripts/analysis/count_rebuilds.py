"""The program behind count_rebuilds.sh, which says what it does."""

import collections
import functools
import json
import os
import re
import shlex

from command import run_program
from rubplot.failure import Failure

TOP = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
CORE = "lib/rubsweep/core/"
DEFAULTS = (
    CORE + "error.hpp", CORE + "model/stop.hpp", CORE + "scene/scene.hpp", CORE + "contact/wall.cpp",
    CORE + "integrate/run/turn.hpp", CORE + "integrate/run/scaled_system.hpp",
    CORE + "integrate/exact/modes/linear_mode.hpp", CORE + "numerics/modal_form.hpp",
    CORE + "response/motion/motion.hpp", "lib/rubsweep/maps/sweep/row.hpp", "examples/one_cell.cpp")
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
# Folders from which files are included by name.
FOLDERS = ("lib", "tests", "apps", "studies")


def includes(path):
    """[(name, whether in quotes)] of the files that a file includes."""
    with open(path, encoding="utf-8") as stream:
        return [(quoted or angled, bool(quoted)) for quoted, angled in INCLUDE.findall(stream.read())]


class Sources:
    """Which files of the tree below `top`, or of a build, a file sees."""

    def __init__(self, top):
        self.top = top

    @functools.lru_cache(maxsize=None)
    def included(self, path, folders):
        """The included files that are the project's own; a batch of a unity build names its sources whole."""
        found = []
        for name, quoted in includes(path):
            places = ((os.path.dirname(path),) if quoted else ()) + folders
            whole = next((file for file in (os.path.normpath(os.path.join(place, name)) for place in places)
                          if file.startswith(self.top + os.sep) and os.path.isfile(file)), None)
            if whole:
                found.append(whole)
        return tuple(found)

    def seen(self, paths, folders):
        """The files themselves and all that they see."""
        seen, left = set(), list(paths)
        while left:
            path = left.pop()
            if path not in seen:
                seen.add(path)
                left.extend(self.included(path, folders))
        return seen


def objects(build, sources):
    """{object: files that it depends on} of the compile commands of a build."""
    found = {}
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as stream:
        commands = json.load(stream)
    for entry in commands:
        words = shlex.split(entry["command"])
        result = words[words.index("-o") + 1]
        if not result.endswith(".o"):
            continue
        folders = tuple(word[2:] for word in words if word.startswith("-I"))
        begin = [entry["file"]] + [words[i + 1] for i, word in enumerate(words) if word == "-include"]
        found[result] = sources.seen([os.path.normpath(os.path.join(entry["directory"], path)) for path in begin], folders)
    return found


def edges(text):
    """[(rule, outputs, inputs)] of a ninja file, without inputs that only order."""
    found = []
    for line in text.splitlines():
        if not line.startswith("build "):
            continue
        made, _, rest = line[len("build "):].partition(": ")
        rule, *needed = rest.split("||")[0].split()
        found.append((rule, made.replace("|", " ").split(), [name for name in needed if name != "|"]))
    return found


def linked_again(ninja_edges, changed):
    """Programs to be linked when the objects `changed` are."""
    users = collections.defaultdict(list)
    for edge in ninja_edges:
        for name in edge[2]:
            users[name].append(edge)
    programs, seen, left = set(), set(changed), list(changed)
    while left:
        for rule, made, _ in users[left.pop()]:
            if rule.startswith("CXX_EXECUTABLE_LINKER"):
                programs.add(made[0])
            # A target that only gathers others links nothing by itself.
            elif rule != "phony":
                left.extend(name for name in made if name not in seen)
                seen.update(made)
    return programs


def count_rebuilds(top, build, files):
    """[(file, objects, links, headers)]"""
    sources = Sources(top)
    of_objects = objects(build, sources)
    with open(os.path.join(build, "build.ninja"), encoding="utf-8") as stream:
        ninja_edges = edges(stream.read())
    folders = tuple(os.path.join(top, folder) for folder in FOLDERS)
    rows = []
    for file in files:
        path = os.path.join(top, file)
        if not os.path.isfile(path):
            raise Failure(f"there is no file {file}")
        changed = [name for name, seen in of_objects.items() if path in seen]
        headers = [seen for seen in sources.seen([path], folders) if seen != path and seen.endswith(".hpp")]
        rows.append((file, len(changed), len(linked_again(ninja_edges, changed)), len(headers)))
    return rows


def main(arguments):
    build = os.path.join(TOP, "build", "release")
    if arguments[:1] == ["--build"]:
        if len(arguments) < 2:
            raise Failure("--build needs the directory of a build")
        build, arguments = os.path.realpath(arguments[1]), arguments[2:]
    if not os.path.isfile(os.path.join(build, "build.ninja")):
        raise Failure(f"{build} is no configured build with ninja; cmake --preset release")
    print("file,objects,links,headers_seen")
    for row in count_rebuilds(TOP, build, arguments or DEFAULTS):
        print(",".join(map(str, row)))


if __name__ == "__main__":
    run_program(main, "count_rebuilds.sh [--build BUILD] [FILE...]", 0, 10000)
