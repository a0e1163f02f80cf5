"""Test cases that let rubplot draw what they write, and look at the picture."""

import hashlib
import os
import re
import struct
import subprocess
import sys
import unittest
import xml.etree.ElementTree
from dataclasses import dataclass

from files import FileTest

SVG = "{http://www.w3.org/2000/svg}"
RUBPLOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scripts/rubplot")


# Size of a letter, as shares of the size of its font.
WIDTH, HEIGHT = 0.6, 0.72


@dataclass(frozen=True)
class Text:
    """Text at a place of the picture, in its own units, y downward; `upright` where it runs upward."""

    text: str
    x: float
    y: float
    size: float
    anchor: str
    upright: bool

    def box(self):
        """(left, top, right, bottom) of what it covers."""
        length = WIDTH * self.size * len(self.text)
        begin = {"start": 0.0, "middle": -0.5, "end": -1.0}[self.anchor] * length
        if self.upright:
            return self.x - HEIGHT * self.size, self.y - begin - length, self.x, self.y - begin
        return self.x + begin, self.y - HEIGHT * self.size, self.x + begin + length, self.y


def sealed(table):
    """A table with the checksum of its lines, as the programs write it."""
    return f"# sha256 {hashlib.sha256(table.encode()).hexdigest()}\n{table}"


def rubplot(*arguments, **environment):
    """Runs the program; returns exit code, standard output and standard error."""
    done = subprocess.run([sys.executable, RUBPLOT, *arguments], check=False, capture_output=True, encoding="utf-8",
                          env={**os.environ, "LC_ALL": "C.UTF-8", **environment})
    return done.returncode, done.stdout, done.stderr


def png_size(path):
    with open(path, "rb") as file:
        begin = file.read(24)
    return struct.unpack(">II", begin[16:24]) if begin.startswith(b"\x89PNG\r\n") else None


class FigureTest(FileTest):
    """draw() makes the picture; without gnuplot the tests are skipped."""

    @classmethod
    def setUpClass(cls):
        try:
            subprocess.run(["gnuplot", "--version"], check=True, stdout=subprocess.DEVNULL)
        except OSError:
            raise unittest.SkipTest("there is no gnuplot") from None

    def write(self, name, text):
        return super().write(name, sealed(text) if name.endswith(".csv") else text)

    def draw(self, subcommand, *arguments, source="."):
        """Lets rubplot draw a file of the test's own directory in all formats; nobody must complain. Returns the root of
        the picture."""
        output = self.path("picture")
        said = rubplot(subcommand, self.path(source), "--output", output, "--formats", "png,svg,pdf", *arguments)
        self.assertEqual(said, (0, "", ""))
        root = xml.etree.ElementTree.parse(output + ".svg").getroot()
        size = tuple(int(number) for number in root.get("viewBox").split()[2:])
        self.assertEqual(png_size(output + ".png"), size)
        with open(output + ".pdf", "rb") as file:
            document = file.read()
        self.assertTrue(document.startswith(b"%PDF-") and len(document) > 1000)
        return root


def texts(root):
    """All texts of a picture that say something."""
    found = []
    for place in root.iter(SVG + "g"):
        for node in place.findall(SVG + "text"):
            text = "".join(node.itertext()).strip()
            if text:
                x, y = re.match(r"translate\(([-0-9.]+),([-0-9.]+)\)", place.get("transform")).groups()
                found.append(Text(text, float(x), float(y), float(place.get("font-size")), place.get("text-anchor"),
                                  "rotate(-90" in place.get("transform")))
    return found


def words(root):
    return [text.text for text in texts(root)]


def over_each_other(root):
    """Pairs of texts of which one covers a part of the other; a text in a box is written twice."""
    found = []
    boxes = [(text.text, text.box()) for text in texts(root)]
    for i, (one, a) in enumerate(boxes):
        for other, b in boxes[i + 1:]:
            if (one, a) != (other, b) and a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]:
                found.append((one, other))
    return found
