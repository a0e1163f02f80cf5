#!/usr/bin/env python3
"""layout_test.py RUBSWEEP TOP: the report of a small map at many sizes of its box, in a headless Chromium.

Reads the picture of the window as an eye does: the numbers at the axes say where a cell is, the pixel there says its
class, and a click there selects it. Nothing is asked of the page's own scales. Exit code 77: there is no Chromium.
"""

import contextlib
import csv
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from webdriver import Browser

rubsweep, top = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
chromium, chromedriver = shutil.which("chromium"), shutil.which("chromedriver")

SPEEDS = [60 + 10 * i for i in range(13)]
RATIOS = [0.02, 0.03, 0.04, 0.06, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]  # thin rows at the foot, as of figure 6
WIDTHS = (700, 1000, 1200, 1400, 1800, 2400)
HEIGHT = 1000
# The selected cell has a frame, which also covers its neighbours.
SELECTED = (12, 12)

# For each axis the number and the middle of each tick, in pixels of the window.
TICKS = """
    const middle = (tick) => { const box = tick.querySelector("line").getBoundingClientRect();
      return [(box.left + box.right) / 2, (box.top + box.bottom) / 2]; };
    const read = (axis) => [...axis.querySelectorAll(".tick")].map((tick) =>
      [Number(tick.textContent.replace("\u2212", "-")), ...middle(tick)]);
    return [...document.querySelectorAll("#overlay .axes > g")].slice(0, 2).map(read)"""
# Pairs of texts of one drawing that lie on each other, and texts that are cut off at its edge.
COLLISIONS = """
    const found = [];
    for (const svg of document.querySelectorAll("#overlay, #panels svg")) {
      const whole = svg.getBoundingClientRect(), own = svg.id || svg.parentNode.id;
      const texts = [...svg.querySelectorAll("text")].filter((text) => text.textContent.trim());
      const boxes = texts.map((text) => text.getBoundingClientRect());
      boxes.forEach((a, i) => {
        if (a.left < whole.left - 1 || a.right > whole.right + 1 || a.top < whole.top - 1 || a.bottom > whole.bottom + 1)
          found.push([own, "cut off", texts[i].textContent]);
        boxes.slice(0, i).forEach((b, j) => {
          const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
          const high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
          if (wide > 0 && high > 2) found.push([own, texts[j].textContent, texts[i].textContent]);
        });
      });
    }
    return found"""
PIXELS = """
    const [picture, places] = arguments, image = new Image();
    image.src = "data:image/png;base64," + picture;
    return image.decode().then(() => {
      const canvas = document.createElement("canvas");
      canvas.width = image.width; canvas.height = image.height;
      const context = canvas.getContext("2d", { willReadFrequently: true });
      context.drawImage(image, 0, 0);
      const hex = (value) => value.toString(16).padStart(2, "0").toUpperCase();
      return places.map(([x, y]) => "#" + [...context.getImageData(x, y, 1, 1).data.slice(0, 3)].map(hex).join(""));
    })"""
TWO_FRAMES = "return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))"


def edges(values):
    between = [(a + b) / 2 for a, b in zip(values, values[1:])]
    return [values[0] - (between[0] - values[0]), *between, values[-1] + (values[-1] - between[-1])]


def scale_of(ticks, direction):
    """Pixels of the window over the numbers of an axis, from its first and last tick."""
    (low, *first), (high, *last) = ticks[0], ticks[-1]
    per_unit = (last[direction] - first[direction]) / (high - low)
    return lambda value: first[direction] + (value - low) * per_unit


class LayoutTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.work)
        grid = f"sweep={{speed_hz: {{from: 60, to: 180, count: 13}}, whirl_ratio: {{values: {RATIOS}}}}}"
        subprocess.run([rubsweep, top / "configs/benchmark/one_side.yaml", "--set", grid, "--output", cls.work / "map",
                        "--quiet"], check=True)
        subprocess.run([rubsweep.parent / "rubreport", cls.work / "map", "--quiet"], check=True)
        lines = [line for line in (cls.work / "map/map.csv").read_text().splitlines() if not line.startswith("#")]
        with open(top / "scripts/rubplot/motion_kinds.csv", encoding="utf-8") as kinds:
            kinds = list(csv.DictReader(kinds))
        # A line crosses the middle of a hatched cell.
        colours = {kind["name"]: kind["colour"] for kind in kinds if kind["hatched"] == "0"}
        rows = list(csv.DictReader(lines))
        place = {(float(row["speed_hz"]), float(row["whirl_ratio"])): row["kind"] for row in rows}
        cls.colours = {(i, j): colours[place[speed, ratio]] for i, speed in enumerate(SPEEDS)
                       for j, ratio in enumerate(RATIOS) if place[speed, ratio] in colours}
        cls.browser = Browser(chromium, chromedriver, cls.work)
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.browser.emulate("prefers-color-scheme", "light")
        self.browser.resize(1300, HEIGHT)
        self.browser.open("about:blank")
        i, j = SELECTED
        self.browser.open((self.work / "map/report.html").as_uri() + f"#speed_hz={SPEEDS[i]}&whirl_ratio={RATIOS[j]}")
        ready = 'return document.documentElement.dataset.ready === "yes"'
        self.browser.wait(lambda: self.browser.run(ready), "the page does not get ready")

    def tearDown(self):
        self.assertEqual([entry for entry in self.browser.log() if entry["level"] in ("SEVERE", "WARNING")], [])

    def middles(self):
        """The middle of each cell on the screen, by the numbers at the axes."""
        across, up = self.browser.run(TICKS)
        x, y = scale_of(across, 0), scale_of(up, 1)
        columns, rows = ([(position(a) + position(b)) / 2 for a, b in zip(ends, ends[1:])]
                         for position, ends in ((x, edges(SPEEDS)), (y, edges(RATIOS))))
        return {(i, j): (x, y) for i, x in enumerate(columns) for j, y in enumerate(rows)}

    def check(self, ratio=1):
        """Colours of all cells but those near the frame, texts, and what three clicks select; `ratio`: pixels of the
        screen to a pixel of the page."""
        self.browser.run(TWO_FRAMES)
        middles = self.middles()
        shown = [cell for cell in self.colours if max(abs(cell[k] - SELECTED[k]) for k in (0, 1)) > 1]
        pixels = self.browser.run(PIXELS, self.browser.screenshot_text(),
                                  [[int(ratio * middles[cell][0]), int(ratio * middles[cell][1])] for cell in shown])
        wrong = [(SPEEDS[i], RATIOS[j], seen, self.colours[i, j]) for (i, j), seen in zip(shown, pixels)
                 if seen != self.colours[i, j]]
        self.assertEqual(wrong, [], f"{len(wrong)} of {len(shown)} cells")
        self.assertEqual(self.browser.run(COLLISIONS), [])
        for i, j in ((0, 0), (7, 2), SELECTED):
            self.browser.click_at(*middles[i, j])
            title = self.browser.run('return document.getElementById("cell-title").textContent')
            self.assertTrue(title.startswith(f"{SPEEDS[i]} Hz ({60 * SPEEDS[i]} rpm), whirl ratio {RATIOS[j]}:"), title)

    @contextlib.contextmanager
    def window(self, width, height=HEIGHT, ratio=1):
        with self.subTest(width=width, height=height, ratio=ratio):
            self.browser.resize(width, height, ratio)
            yield

    def test_at_six_widths(self):
        self.assertGreaterEqual(len(set(self.colours.values())), 5)
        for width in WIDTHS:
            with self.window(width):
                self.check()

    def test_a_turned_screen(self):
        for size in ((800, 1280), (1280, 800), (412, 915), (915, 600)):
            with self.window(*size):
                self.check()

    def test_a_zoomed_page(self):
        """As a browser zooms: the window has fewer pixels of the page, and each has more of the screen."""
        for ratio in (0.75, 1.25, 1.5, 2):
            with self.window(round(1600 / ratio), round(1500 / ratio), ratio):
                self.check(ratio)

    def test_a_zoom_that_leaves_the_boxes_alone_is_sharp(self):
        """A page has a greatest width, so that its boxes keep theirs in a wide window."""
        for ratio in (2, 1.25, 1):
            with self.window(2400 + round(100 / ratio), 1100, ratio):
                self.browser.run(TWO_FRAMES)
                drawn, shown = self.browser.run(
                    'return [document.getElementById("cells").width, document.getElementById("map").clientWidth]')
                self.assertAlmostEqual(drawn, ratio * shown, delta=2)

    def test_a_box_that_changes_without_the_window(self):
        for change in ("document.body.style.maxWidth = '760px'", "document.body.style.maxWidth = '980.5px'",
                       "document.getElementById('map').style.height = '430px'",
                       "document.documentElement.style.fontSize = '22px'"):
            with self.subTest(change=change):
                self.browser.run(change)
                self.check()

    def test_panels_are_drawn_for_their_width(self):
        drawn = 'return document.querySelector("#orbit svg").viewBox.baseVal.width'
        own = 'return document.getElementById("orbit").clientWidth'
        for change in ("document.body.style.maxWidth = '1150px'", "document.body.style.maxWidth = '1260px'"):
            self.browser.run(change)
            self.browser.wait(lambda: self.browser.run(drawn) == self.browser.run(own), "panels keep their old width", 5)


if __name__ == "__main__":
    if not chromium or not chromedriver:
        print("there is no chromium or no chromedriver: scripts/browser_test.sh installs them")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
