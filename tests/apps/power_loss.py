"""Contents of a disk after a loss of power, from what tests/support/io_recorder.cpp recorded.

power_loss.py whole RECORD TOP BEFORE COMMAND...: at each recorded call the power goes. COMMAND, run on what is left, must
    end with 0 and leave the map that TOP holds now; cells that were safe on the disk once must be so ever after.
power_loss.py alike RECORD TOP BEFORE: whenever the power goes, all tables with a checksum have one digest.

TOP is the recorded directory as the program left it, BEFORE a copy from before, or - where there was none.
"""

import os
import re
import shutil
import subprocess
import sys


class File:
    def __init__(self, content=b""):
        self.now, self.safe = bytearray(content), bytes(content)


class Disk:
    """Files and directories by their paths below TOP: as the program sees them, and as they are safe on the disk."""

    def __init__(self, top, before):
        self.top, self.opened = top, {}
        self.now = {"": None}  # a directory is None
        for directory, below, files in os.walk(before) if before != "-" else ():
            place = os.path.relpath(directory, before)
            for name in below:
                self.now[os.path.normpath(os.path.join(place, name))] = None
            for name in files:
                with open(os.path.join(directory, name), "rb") as file:
                    self.now[os.path.normpath(os.path.join(place, name))] = File(file.read())
        self.safe = dict(self.now)
        self.gone = set()  # names that were removed or renamed and may come back

    def path(self, absolute):
        relative = os.path.relpath(absolute, self.top)
        return "" if relative == "." else relative

    def call(self, line):
        word, rest = line.rstrip("\n").split(" ", 1)
        getattr(self, "_" + word)(rest)

    def _open(self, rest):
        number, age, state, path = rest.split(" ", 3)
        path = self.path(path)
        if age == "new":
            self.now[path] = File()
        elif state == "empty":
            self.now[path].now.clear()
        self.opened[number] = self.now[path]

    def _write(self, rest):
        number, offset, data = rest.split(" ")
        content, place, data = self.opened[number].now, int(offset), bytes.fromhex(data)
        content[place : place + len(data)] = data

    def _truncate(self, rest):
        number, length = rest.split(" ")
        del self.opened[number].now[int(length) :]

    def _sync(self, number):
        self.opened[number].safe = bytes(self.opened[number].now)

    def _remove(self, path):
        del self.now[self.path(path)]
        self.gone.add(self.path(path))

    def _mkdir(self, path):
        self.now[self.path(path)] = None

    def _rename(self, rest):
        old, new = (self.path(path) for path in rest.split("\t"))
        self.now[new] = self.now.pop(old)
        self.gone.add(old)

    def _syncdir(self, path):
        here = self.path(path)
        for place in {*self.now, *self.safe}:
            if place and os.path.dirname(place) == here:
                if place in self.now:
                    self.safe[place] = self.now[place]
                else:
                    self.safe.pop(place, None)
                self.gone.discard(place)

    def left(self):
        """The states that may be left: names as they were synced, the same without those removed since, names as the program sees
        them; each with the contents that were synced."""
        yield self._contents(self.safe)
        yield self._contents({place: node for place, node in self.safe.items() if place not in self.gone})
        yield self._contents(self.now)

    @staticmethod
    def _contents(nodes):
        found = {}
        for place in sorted(nodes):
            if place and os.path.dirname(place) in found or os.path.dirname(place) == "":
                found[place] = None if nodes[place] is None else nodes[place].safe
        return found


def states(record, top, before):
    """Yields (number of calls, what may be left) for every call after which something new may be."""
    disk, known = Disk(top, before), set()
    with open(record, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            disk.call(line)
            for kind, left in enumerate(disk.left()):
                left = {place: content for place, content in left.items() if not place.endswith(".lock")}
                key = (kind, tuple(left.items()))
                if key not in known:
                    known.add(key)
                    yield number, kind, left


def write(left, top):
    shutil.rmtree(top, ignore_errors=True)
    os.mkdir(top)
    for place, content in left.items():
        path = os.path.join(top, place)
        if not place:
            continue
        if content is None:
            os.makedirs(path, exist_ok=True)
        else:
            with open(path, "wb") as file:
                file.write(content)


def safe_cells(left, whole):
    """How many cells somebody who comes back finds: those of the whole map, or the good lines of a journal."""
    for place, content in left.items():
        if content is not None and os.path.basename(place) == "map.csv" and content == whole:
            return len([line for line in whole.splitlines() if not line.startswith(b"#")]) - 1
    journals = [content for place, content in left.items() if content is not None and place.endswith(".journal")]
    return sum(len(re.findall(rb"^[0-9a-f]{8} [0-9]+ [^\n]*,[^\n]*\n", content, re.MULTILINE)) for content in journals)


def map_in(top):
    [path] = [os.path.join(directory, "map.csv") for directory, _, files in os.walk(top) if "map.csv" in files]
    with open(path, "rb") as file:
        return file.read()


def check_whole(record, top, before, command):
    whole, promised, tried = map_in(top), 0, {}
    for number, kind, left in states(record, top, before):
        cells = safe_cells(left, whole)
        if cells < promised:
            sys.exit(f"power_loss.py: call {number}, kind {kind}: {promised} cells were safe, {cells} are left")
        if kind == 0:
            promised = max(promised, cells)
        key = tuple(left.items())
        if key in tried:
            continue
        write(left, top)
        ended = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
        tried[key] = ended.returncode
        if ended.returncode != 0 or map_in(top) != whole:
            sys.exit(f"power_loss.py: call {number}, kind {kind}: exit code {ended.returncode}\n{ended.stderr}")
    if promised == 0:
        sys.exit("power_loss.py: nothing was ever safe")
    print(f"{len(tried)} different disks, {promised} cells safe at the end")


def check_alike(record, top, before):
    seen = set()
    for number, kind, left in states(record, top, before):
        digests = set()
        for place, content in left.items():
            if ".tmp-" not in place:
                digests.update(re.findall(rb"^# digest (\S+)$", content or b"", re.MULTILINE))
        if len(digests) > 1:
            tables = sorted(place for place in left if place.endswith(".csv"))
            sys.exit(f"power_loss.py: call {number}, kind {kind}: tables of two studies side by side: {tables}")
        seen |= digests
    print(f"{len(seen)} studies, never two at once")


if __name__ == "__main__":
    _, what, *arguments = sys.argv
    if what == "whole":
        check_whole(*arguments[:3], arguments[3:])
    else:
        check_alike(*arguments)
