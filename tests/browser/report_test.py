#!/usr/bin/env python3
"""report_test.py RUBSWEEP RUBTRACE TOP [SCREENSHOTS]: the report of a small map in a headless Chromium.

Clicks, keys and exports as a reader does them; the orbit that a click shows is compared with the one that rubtrace
computes for that cell. With SCREENSHOTS, a directory, leaves pictures there. Exit code 77: there is no Chromium.
"""

import csv
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
import zlib

from webdriver import Browser

rubsweep, rubtrace, top = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
screenshots = pathlib.Path(sys.argv[4]).resolve() if len(sys.argv) > 4 else None
chromium, chromedriver = shutil.which("chromium"), shutil.which("chromedriver")

# Colours of the figures, see scripts/rubplot/motion_kinds.csv.
COLOURS = {"non_contact": "#F4F4F4", "2": "#CC6677", "3": "#332288", "4": "#DDCC77", "5": "#117733"}
RIGHT, LEFT, UP, DOWN, SHIFT, ESCAPE = "\ue014", "\ue012", "\ue013", "\ue015", "\ue008", "\ue00c"


def rows_of(path):
    lines = [line for line in path.read_text().splitlines() if line and not line.startswith("#")]
    return list(csv.DictReader(lines))


def png_size(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big")


class ReportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.work)
        cls.map = cls.work / "map"
        cls.config = top / "configs/benchmark/one_side.yaml"
        cls.map.mkdir()
        grid = "sweep={speed_hz: {from: 60, to: 180, count: 13}, whirl_ratio: {from: 0.1, to: 0.9, count: 9}}"
        subprocess.run([rubsweep, cls.config, "--set", grid, "--output", cls.map, "--quiet"], check=True)
        # A new map takes boundaries of an old one away.
        (cls.map / "boundaries.csv").write_text(
            "family,kind,point,speed_hz,unbalance\nedge,fold,0,60,0.1\nedge,fold,1,120,0.9\n")
        subprocess.run([rubsweep.parent / "rubreport", cls.map, "--quiet"], check=True)
        cls.rows = rows_of(cls.map / "map.csv")
        cls.downloads = cls.work / "downloads"
        cls.downloads.mkdir()
        cls.browser = Browser(chromium, chromedriver, cls.downloads)
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.browser.emulate("prefers-color-scheme", "light")
        self.open()

    def tearDown(self):
        complaints = [entry for entry in self.browser.log() if entry["level"] in ("SEVERE", "WARNING")]
        self.assertEqual(complaints, [])

    def open(self, fragment="", page=None):
        self.browser.open("about:blank")
        self.browser.open((page or self.map / "report.html").as_uri() + fragment)
        ready = 'return document.documentElement.dataset.ready === "yes" || ' \
                '(document.getElementById("problem") || {}).textContent'
        self.assertIs(self.browser.wait(lambda: self.browser.run(ready), "the page does not get ready"), True)

    def cell(self, speed_hz, whirl_ratio):
        matches = [i for i, row in enumerate(self.rows)
                   if float(row["speed_hz"]) == speed_hz and abs(float(row["whirl_ratio"]) - whirl_ratio) < 1e-9]
        self.assertEqual(len(matches), 1)
        return matches[0]

    def click_cell(self, cell):
        self.browser.click_at(*self.browser.run("return view.middleOf(arguments[0])", cell))
        self.wait_for_panels(cell)

    def wait_for_panels(self, cell):
        shown = 'return document.getElementById("panels").dataset.cell'
        self.browser.wait(lambda: self.browser.run(shown) == str(cell), f"cell {cell} is not shown")

    def colour_of(self, cell):
        """The colour in the middle of a cell, as #RRGGBB."""
        return self.browser.run("""
            const [x, y] = view.middleOf(arguments[0]), box = view.canvas.getBoundingClientRect();
            const ratio = view.canvas.width / box.width;
            const one = document.createElement("canvas").getContext("2d");
            one.drawImage(view.canvas, -Math.floor((x - box.left) * ratio), -Math.floor((y - box.top) * ratio));
            const pixel = one.getImageData(0, 0, 1, 1);
            return "#" + Array.from(pixel.data.slice(0, 3), (v) => v.toString(16).padStart(2, "0")).join("").toUpperCase()
            """, cell)

    def downloaded(self, name):
        path = self.downloads / name
        path.unlink(missing_ok=True)
        return lambda: self.browser.wait(lambda: path.exists() and path.stat().st_size and path, f"no {name} came")

    def picture(self, name):
        if screenshots:
            screenshots.mkdir(parents=True, exist_ok=True)
            self.browser.whole_screenshot(screenshots / name)

    def test_cells_have_the_colours_of_their_classes(self):
        seen = set()
        for cell, row in enumerate(self.rows):
            kind = row["order"] if row["class"] == "subharmonic" else row["class"]
            if kind in COLOURS:
                self.assertEqual(self.colour_of(cell), COLOURS[kind], row)
                seen.add(kind)
        self.assertGreaterEqual(seen, {"non_contact", "2", "3", "4"})

    def test_a_click_shows_the_orbit_that_rubtrace_computes(self):
        for speed_hz, ratio in ((80, 0.6), (120, 0.4), (160, 0.5), (60, 0.2)):
            with self.subTest(speed_hz=speed_hz, ratio=ratio):
                cell = self.cell(speed_hz, ratio)
                self.click_cell(cell)
                self.compare_with_trace(cell)

    def compare_with_trace(self, cell):
        row = self.rows[cell]
        orbit = self.browser.run("return data.orbit(arguments[0])", cell)
        last = orbit["first_revolution"] + orbit["turns"]
        rest = row["class"] == "non_contact"
        trace = self.work / "trace"
        subprocess.run(
            [rubtrace, self.map / "config.yaml", "--speed-hz", row["speed_hz"], "--whirl-ratio", row["whirl_ratio"],
             "--revolutions", str(1500 if rest else last), "--last-revolutions", str(orbit["turns"]), "--set",
             f"response.samples_per_revolution={orbit['steps_per_turn']}", "--output", trace, "--quiet"], check=True)
        samples = rows_of(trace / "trajectory.csv")
        extent = max(float(row["peak_displacement_m"]), 1e-5)
        drawn = {"x_m": orbit["x"], "y_m": orbit["y"], "casing_0_x_m": orbit["stops"][0]["x"],
                 "casing_0_y_m": orbit["stops"][0]["y"], "gap_0_m": orbit["stops"][0]["gap"]}
        compared = 0
        for place, step in enumerate(orbit["steps"]):
            if step == len(samples):  # the end of the last turn is no sample of a trace
                continue
            for name, values in drawn.items():
                self.assertAlmostEqual(values[place], float(samples[step][name]), delta=extent / 4000, msg=name)
                compared += 1
        self.assertGreater(compared, 100)
        section = [(float(point["x_m"]), float(point["y_m"])) for point in rows_of(trace / "section.csv")]
        first = section[-1 - orbit["turns"]] if not rest else section[-1]
        self.assertAlmostEqual(orbit["section"][0][0], first[0], delta=extent / 4000)
        self.assertAlmostEqual(orbit["section"][0][1], first[1], delta=extent / 4000)
        # The panels draw just these: as many dots as section points, as many lines as the spectrum has.
        self.assertEqual(self.browser.run('return document.querySelectorAll("#section circle").length'),
                         len(orbit["section"]))
        self.assertEqual(self.browser.run('return document.querySelectorAll("#spectrum svg > g line[y1]").length > 0'),
                         True)
        self.compare_spectrum(orbit, trace, rest)

    def compare_spectrum(self, orbit, trace, rest):
        expected = {round(float(line["order"]), 9): float(line["amplitude_m"]) for line in rows_of(trace / "spectrum.csv")}
        largest = max(line["amplitude_m"] for line in orbit["spectrum"])
        self.assertTrue(orbit["spectrum"])
        for line in orbit["spectrum"]:
            self.assertAlmostEqual(line["amplitude_m"], expected[round(line["order"], 9)], delta=5e-3 * largest)

    def test_keys_move_and_mark_and_let_go(self):
        cell = self.cell(110, 0.5)
        self.click_cell(cell)
        speeds = 13
        for key, step in ((RIGHT, 1), (UP, speeds), (LEFT, -1), (DOWN, -speeds)):
            self.browser.press("#map", key)
            cell += step
            self.wait_for_panels(cell)
        self.browser.press("#map", SHIFT + RIGHT + RIGHT + UP)
        self.wait_for_panels(cell + 2 + speeds)
        self.assertEqual(self.browser.run("return chosenCells()"),
                         [cell, cell + 1, cell + 2, cell + speeds, cell + speeds + 1, cell + speeds + 2])
        self.browser.press("#map", ESCAPE)
        self.assertEqual(self.browser.run("return chosenCells().length"), len(self.rows))
        for _ in range(20):
            self.browser.press("#map", LEFT)
        self.wait_for_panels(self.cell(60, 0.6))  # the edge holds

    def hover(self):
        return self.browser.run('return document.getElementById("hover").textContent')

    def test_the_line_below_the_map_follows_the_keys(self):
        self.click_cell(self.cell(80, 0.6))
        self.assertIn("80 Hz (4800 rpm), whirl ratio 0.6", self.hover())
        self.browser.press("#map", RIGHT + UP)
        self.wait_for_panels(self.cell(90, 0.7))
        self.assertIn("90 Hz (5400 rpm), whirl ratio 0.7", self.hover())
        # The mouse shows another cell, and lets go of it beside the map.
        self.browser.mouse(("move", *self.browser.run("return view.middleOf(arguments[0])", self.cell(120, 0.4))))
        self.assertIn("120 Hz (7200 rpm), whirl ratio 0.4", self.hover())
        self.browser.mouse(("move", 5, 5))
        self.assertIn("90 Hz (5400 rpm), whirl ratio 0.7", self.hover())

    def test_a_cell_without_a_motion_shows_one_of_its_kind_or_none(self):
        thinned = self.work / "thinned.html"
        subprocess.run([rubsweep.parent / "rubreport", self.map, "--orbits", "12", "--output", thinned, "--quiet"], check=True)
        self.open(page=thinned)
        kinds = self.browser.run("""
            const key = (cell) => cell === null ? null : [data.value("class", cell), String(data.value("order", cell))].join();
            return d3.range(data.cells).map((cell) => [key(cell), key(data.recordedCell(cell)), data.recordedCells().map(key)])
            """)
        self.assertGreater(len({own for own, _, _ in kinds}), 4)
        for own, shown, recorded in kinds:
            self.assertEqual(shown, own if own in recorded else None)
        missing = next(cell for cell, (_, shown, _) in enumerate(kinds) if shown is None)
        self.browser.click_at(*self.browser.run("return view.middleOf(arguments[0])", missing))
        note = 'return document.getElementById("cell-note").textContent'
        self.browser.wait(lambda: "No motion of its kind is stored" in self.browser.run(note), "it does not say so")
        self.assertEqual(self.browser.run('return document.querySelectorAll("#panels svg").length'), 0)

    def test_hover_says_the_numbers_of_the_cell(self):
        cell = self.cell(80, 0.6)
        self.browser.mouse(("move", *self.browser.run("return view.middleOf(arguments[0])", cell)))
        said = self.browser.run('return document.getElementById("hover").textContent')
        force = float(self.rows[cell]["peak_contact_force_n"])
        for part in ("80 Hz (4800 rpm), whirl ratio 0.6", "subharmonic 1/2", f"peak contact force {force:.4g} N"):
            self.assertIn(part, said)

    def test_every_layer_draws_and_changes_the_picture(self):
        layers = self.browser.run('return [...document.querySelectorAll("#layer option")].map((o) => o.value)')
        self.assertGreaterEqual(set(layers), {"class", "proof", "floquet_modulus", "peak_contact_force_n",
                                              "peak_displacement_m", "hits_per_revolution", "revolutions"})
        pictures = set()
        for layer in layers:
            self.browser.choose("#layer", layer)
            pictures.add(zlib.crc32(self.browser.run("return view.canvas.toDataURL()").encode()))
            self.assertEqual(self.browser.run("return state.layer"), layer)
        self.assertGreater(len(pictures), len(layers) // 2)
        self.browser.choose("#layer", "peak_contact_force_n")
        forces = [float(row["peak_contact_force_n"] or 0) for row in self.rows]
        strongest = self.colour_of(forces.index(max(forces)))
        self.assertEqual(strongest, "#FDEA45")  # the light end of cividis
        self.picture("report_layer.png")

    def test_a_class_can_be_hidden(self):
        cell = self.cell(120, 0.4)
        self.assertEqual(self.colour_of(cell), COLOURS["3"])
        self.browser.click('input[data-kind="subharmonic_3"]')
        self.assertEqual(self.colour_of(cell), "#FFFFFF")
        thirds = sum(row["order"] == "3" for row in self.rows)
        self.assertEqual(self.browser.run("return chosenCells().length"), len(self.rows) - thirds)

    def test_rows_are_exported_as_the_map_has_them(self):
        a, b = self.cell(80, 0.3), self.cell(100, 0.6)
        start, end = (self.browser.run("return view.middleOf(arguments[0])", cell) for cell in (a, b))
        self.browser.mouse(("move", *start), ("down",), ("move", *end), ("up",))
        arrived = self.downloaded("rows.csv")
        self.browser.click("#rows")
        exported = rows_of(arrived())
        expected = [row for row in self.rows
                    if 80 <= float(row["speed_hz"]) <= 100 and 0.299 < float(row["whirl_ratio"]) < 0.601]
        self.assertEqual(len(expected), 12)
        self.assertEqual(len(exported), len(expected))
        for one, other in zip(exported, expected):
            self.assertEqual(list(one), list(other))
            for name, text in other.items():
                try:
                    self.assertEqual(float(one[name]), float(text))
                except ValueError:
                    self.assertEqual(one[name], text)

    def test_pictures_are_exported(self):
        arrived = self.downloaded("map.png")
        self.browser.click("#map-png")
        width, height = png_size(arrived().read_bytes())
        self.assertGreater(width, 1000)
        self.assertGreater(height, 500)
        for name, button in (("map.svg", "#map-svg"), ("orbit.svg", "#orbit button"), ("history.svg", "#history button")):
            arrived = self.downloaded(name)
            self.browser.click(button)
            root = xml.etree.ElementTree.fromstring(arrived().read_text())
            self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
            texts = {"".join(node.itertext()) for node in root.iter("{http://www.w3.org/2000/svg}text")}
            self.assertTrue(texts & {"speed (Hz)", "x (mm)", "displacement (mm)"}, name)
        if screenshots:
            screenshots.mkdir(parents=True, exist_ok=True)
            for name in ("map.png", "map.svg", "orbit.svg"):
                shutil.copy(self.downloads / name, screenshots / ("export_" + name))

    def test_a_link_remembers_cell_and_layer(self):
        cell = self.cell(160, 0.5)
        self.browser.choose("#layer", "revolutions")
        self.click_cell(cell)
        address = self.browser.wait(
            lambda: self.browser.run('return location.hash.includes("speed_hz=160") ? location.hash : ""'), "no address")
        self.open(address)
        self.wait_for_panels(cell)
        self.assertEqual(self.browser.run("return state.layer"), "revolutions")
        self.assertIn("160 Hz", self.browser.run('return document.getElementById("cell-title").textContent'))

    def test_a_boundary_is_drawn(self):
        self.assertEqual(self.browser.run('return document.querySelectorAll("#overlay .boundaries path").length'), 1)
        self.assertEqual(self.browser.run('return document.querySelector("#overlay .boundaries title").textContent'),
                         "edge: fold")

    def test_words_stand_in_the_page(self):
        text = self.browser.run("return document.body.innerText")
        for part in ("117 cells: 13 speeds from 60 to 180 Hz (3600 to 10800 rpm)", "Rub lasts in", "rotor: Jeffcott", "solver: exact"):
            self.assertIn(part, text)
        self.assertIn("natural_frequency_hz: 30",
                      self.browser.run('return document.getElementById("configuration").textContent'))

    def test_no_network_is_asked_and_none_is_allowed(self):
        self.browser.log("performance")
        self.open()
        asked = [entry["message"] for entry in self.browser.log("performance")
                 if '"Network.requestWillBeSent"' in entry["message"]]
        self.assertTrue(asked)
        for message in asked:
            self.assertNotRegex(message, r'"url":"(https?|wss?|ftp):')
        # The policy holds: an address on this machine is refused by the page itself, not by the network.
        refused = self.browser.run("""
            return new Promise((resolve) => {
              document.addEventListener("securitypolicyviolation", (event) => resolve(event.effectiveDirective));
              fetch("http://127.0.0.1:9/").catch(() => {});
              setTimeout(() => resolve("nothing"), 5000);
            })""")
        self.assertEqual(refused, "connect-src")
        self.browser.log()  # that refusal is no complaint

    def test_dark_screens_paper_and_phones(self):
        self.picture("report_light.png")
        self.browser.emulate("prefers-color-scheme", "dark")
        self.browser.wait(lambda: self.colour_of(self.cell(60, 0.1)) == "#2B2F36", "the map does not get dark")
        self.picture("report_dark.png")
        # On paper the page is light whatever the screen is.
        self.browser.emulate("prefers-color-scheme", "dark", medium="print")
        self.browser.run('window.dispatchEvent(new Event("beforeprint"))')
        self.assertEqual(self.colour_of(self.cell(60, 0.1)), COLOURS["non_contact"])
        ground = "return getComputedStyle(document.body).backgroundColor"
        self.assertEqual(self.browser.run(ground), "rgb(255, 255, 255)")
        self.picture("report_paper.png")
        self.browser.run('window.dispatchEvent(new Event("afterprint"))')
        self.browser.emulate("prefers-color-scheme", "light")
        try:
            self.browser.resize(375, 800)
            fits = "return document.documentElement.scrollWidth <= document.documentElement.clientWidth"
            self.browser.wait(lambda: self.browser.run(fits), "a phone has to scroll sideways")
            self.browser.wait(lambda: self.browser.run("return view.width < 375"), "the map is not drawn anew")
            self.picture("report_phone.png")
        finally:
            self.browser.usual_size()


if __name__ == "__main__":
    if not chromium or not chromedriver:
        print("there is no chromium or no chromedriver: scripts/browser_test.sh installs them")
        sys.exit(77)
    os.environ["LC_ALL"] = "C.UTF-8"
    unittest.main(argv=sys.argv[:1], verbosity=2)
