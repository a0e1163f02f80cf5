#!/usr/bin/env python3
"""site_test.py SITE [SCREENSHOTS]: the web pages of the documents in a headless Chromium at the widths of a telephone, a tablet and
a desk: no page is wider than the window, the search finds a key and opens its meaning, keys in the text lead to the reference,
pictures open, dark and light, and nothing is asked of another host.

With SCREENSHOTS, a directory, leaves pictures there. Exit code 77: there is no Chromium.
"""

import json
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

from webdriver import Browser

site = pathlib.Path(sys.argv[1]).resolve()
screenshots = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
chromium, chromedriver = shutil.which("chromium"), shutil.which("chromedriver")

WIDTHS = {375: 800, 800: 1000, 1400: 1000}
ENTER = "\ue007"
# Elements that reach beyond the window and stand in no box that scrolls.
TOO_WIDE = """
    const scrolls = (element) => element && element !== document.body &&
      (["auto", "scroll"].includes(getComputedStyle(element).overflowX) || scrolls(element.parentElement));
    const wide = [...document.querySelectorAll("main *, header *")].filter((element) =>
      element.getBoundingClientRect().right > innerWidth + 1 && !scrolls(element) && element.getClientRects().length);
    return [document.documentElement.scrollWidth, innerWidth, wide.slice(0, 5).map((element) =>
      `${element.tagName} ${element.textContent.slice(0, 40)}`)];"""


def luminance(colour):
    red, green, blue = (int(part) for part in re.findall(r"\d+", colour)[:3])
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


class SiteTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.work)
        cls.browser = Browser(chromium, chromedriver, cls.work)
        cls.addClassCleanup(cls.browser.close)
        cls.pages = sorted(path.relative_to(site).as_posix() for path in site.rglob("*.html")
                           if path.relative_to(site).parts[0] != "library")

    def setUp(self):
        self.browser.emulate("prefers-color-scheme", "light")
        self.browser.resize(1400, 1000)
        self.open("index.html")
        self.browser.run("try { localStorage.clear(); } catch (error) { }; document.documentElement.dataset.theme = ''")

    def tearDown(self):
        self.assertEqual([entry for entry in self.browser.log() if entry["level"] in ("SEVERE", "WARNING")], [])

    def open(self, page):
        self.browser.open("about:blank")
        self.browser.open((site / page).as_uri())
        self.browser.wait(lambda: self.browser.run('return document.documentElement.dataset.ready === "yes"'),
                          f"{page} does not get ready")

    def look_for(self, text):
        self.browser.press("#search", text)
        self.browser.wait(lambda: self.browser.run("return !document.getElementById('found').hidden"), f"nothing found for {text}")

    def place(self):
        """The page and the name in it that the window shows."""
        address = self.browser.run("return location.href")
        return address.removeprefix(site.as_uri() + "/")

    def test_no_page_is_wider_than_the_window(self):
        wrong = []
        self.assertGreater(len(self.pages), 20)
        for page in self.pages:
            self.open(page)
            self.assertNotIn("@", self.browser.run("return document.querySelector('#menu').textContent"))
            for width, height in WIDTHS.items():
                self.browser.resize(width, height)
                whole, window, wide = self.browser.run(TOO_WIDE)
                if whole > window or wide:
                    wrong.append((page, width, whole, wide))
        self.assertEqual(wrong, [])

    def test_the_search_finds_a_key_and_opens_its_meaning(self):
        for width, height in WIDTHS.items():
            for start in ("index.html", "docs/reference/programs/rubtrace.html"):
                with self.subTest(width=width, start=start):
                    self.browser.resize(width, height)
                    self.open(start)
                    self.look_for("stops.N.friction.coefficient")
                    left, right = self.browser.run("const box = document.getElementById('found').getBoundingClientRect(); "
                                                   "return [box.left, box.right]")
                    self.assertTrue(0 <= left < right <= width, (left, right))
                    self.browser.press("#search", ENTER)
                    self.browser.wait(lambda: "#" in self.place(), "the key is not opened")
                    self.assertEqual(self.place(), "docs/reference/keys/stops.html#stops.N.friction.coefficient")
                    shown = self.browser.run("return document.querySelector(':target').textContent")
                    self.assertIn("dry friction", shown)

    def test_the_search_finds_words_of_a_text(self):
        self.look_for("keyphasor threshold")
        texts = self.browser.run("return [...document.querySelectorAll('#found a')].map((link) => link.textContent)")
        self.assertTrue(texts and all("keyphasor" in text.lower() for text in texts[:3]), texts[:3])
        self.browser.run("document.getElementById('search').value = ''")
        self.look_for("zzzyx")
        self.assertEqual(self.browser.run("return document.getElementById('found').textContent"), "Nothing found.")

    def test_keys_in_the_text_lead_to_their_meaning(self):
        pages = [page for page in self.pages if 'class="key"' in (site / page).read_text(encoding="utf-8")]
        self.assertGreater(len(pages), 5)
        self.open("docs/tutorial.html" if "docs/tutorial.html" in pages else pages[0])
        name = self.browser.run("const link = document.querySelector('main a.key'); link.click(); return link.textContent")
        self.browser.wait(lambda: "docs/reference/" in self.place() or "docs/keys" in self.place(), f"{name} is not opened")
        self.assertTrue(self.browser.run("return document.querySelector(':target') !== null"))

    def test_dark_and_light(self):
        colours = "const style = getComputedStyle(document.body); return [style.backgroundColor, style.color]"
        for system in ("light", "dark"):
            self.browser.emulate("prefers-color-scheme", system)
            self.open("index.html")
            paper, text = map(luminance, self.browser.run(colours))
            self.assertEqual(paper < text, system == "dark", (paper, text))
            self.assertGreater(abs(paper - text), 150)
            self.browser.click("#theme-button")
            paper, text = map(luminance, self.browser.run(colours))
            self.assertEqual(paper < text, system != "dark", (paper, text))
            self.browser.click("#theme-button")
        # Links stand out of either paper.
        for theme in ("light", "dark"):
            self.browser.run("document.documentElement.dataset.theme = arguments[0]", theme)
            link, paper = self.browser.run("return [getComputedStyle(document.querySelector('main a')).color, "
                                           "getComputedStyle(document.body).backgroundColor]")
            self.assertGreater(abs(luminance(link) - luminance(paper)), 100)

    def test_the_menu_folds_on_a_telephone(self):
        visible = "return document.getElementById('menu').getClientRects().length > 0"
        self.assertTrue(self.browser.run(visible))
        self.browser.resize(375, 800)
        self.assertFalse(self.browser.run(visible))
        self.browser.click("#menu-button")
        self.assertTrue(self.browser.run(visible))
        self.browser.run("document.querySelector('#text h1').click()")
        self.assertFalse(self.browser.run(visible))

    def test_pictures_open_large(self):
        self.open("docs/gallery.html")
        opened = "return document.querySelector('dialog').open"
        self.assertFalse(self.browser.run(opened))
        self.browser.run("document.querySelector('a.picture').click()")
        self.assertTrue(self.browser.run(opened))
        self.browser.wait(lambda: self.browser.run("return document.querySelector('dialog img').naturalWidth > 0"), "no picture")
        self.browser.run("document.querySelector('dialog').click()")
        self.assertFalse(self.browser.run(opened))

    def test_formulas_are_set(self):
        self.open("docs/method/design.html")
        for width, height in WIDTHS.items():
            self.browser.resize(width, height)
            over, under = self.browser.run("return [...document.querySelector('div.formula .fraction').children].map((part) => "
                                           "[part.getBoundingClientRect().top, part.getBoundingClientRect().bottom])")
            self.assertTrue(over[0] < over[1] <= under[0] + 1 < under[1], (over, under))
        self.assertEqual(self.browser.run("return getComputedStyle(document.querySelector('.math i')).fontStyle"), "italic")

    def test_chapters_lead_to_the_next(self):
        pages = [page for page in self.pages if 'class="neighbours"' in (site / page).read_text(encoding="utf-8")]
        self.assertGreater(len(pages), 3)
        self.open(pages[0])
        links = self.browser.run("return document.querySelectorAll('.neighbours a').length")
        self.assertIn(links, (1, 2))

    def test_nothing_is_asked_of_another_host(self):
        self.browser.log("performance")
        self.open("docs/gallery.html")
        self.look_for("friction")
        asked = [json.loads(entry["message"])["message"] for entry in self.browser.log("performance")]
        addresses = [event["params"]["request"]["url"] for event in asked if event["method"] == "Network.requestWillBeSent"]
        self.assertTrue(any(address.endswith("search_index.js") for address in addresses), addresses)
        self.assertEqual([address for address in addresses if not address.startswith(("file:", "data:", "about:", "blob:"))], [])

    @unittest.skipUnless(screenshots, "no directory for pictures")
    def test_pictures_of_pages(self):
        screenshots.mkdir(parents=True, exist_ok=True)
        shown = ["index.html", "docs/tutorial.html", "docs/reference/README.html", "docs/reference/programs/rubsweep.html",
                 "docs/reference/keys/stops.html", *[page for folder in ("guide", "method") for page in
                   [page for page in self.pages if page.startswith(f"docs/{folder}/")][:2]]]
        for theme in ("light", "dark"):
            self.browser.emulate("prefers-color-scheme", theme)
            for width, height in WIDTHS.items():
                self.browser.resize(width, height)
                for page in shown:
                    self.open(page)
                    self.browser.screenshot(screenshots / f"{page.replace('/', '_').removesuffix('.html')}_{width}_{theme}.png")
                self.open("docs/reference/README.html")
                self.look_for("friction")
                self.browser.screenshot(screenshots / f"search_{width}_{theme}.png")
                if width < 800:
                    self.open("index.html")
                    self.browser.click("#menu-button")
                    self.browser.screenshot(screenshots / f"menu_{width}_{theme}.png")


if __name__ == "__main__":
    if not chromium or not chromedriver:
        print("there is no chromium or no chromedriver: scripts/browser_test.sh installs them")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
