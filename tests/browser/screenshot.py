#!/usr/bin/env python3
"""screenshot.py REPORT.html PICTURE.png [light|dark] [WIDTH HEIGHT]: the top of a report as a browser shows it."""

import pathlib
import shutil
import sys

from webdriver import Browser

report, picture = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
scheme = sys.argv[3] if len(sys.argv) > 3 else "light"
size = [int(number) for number in sys.argv[4:6]] or [1500, 980]
with Browser(shutil.which("chromium"), shutil.which("chromedriver"), picture.parent, size) as browser:
    browser.emulate("prefers-color-scheme", scheme)
    browser.resize(*size)
    browser.open(report.as_uri())
    browser.wait(lambda: browser.run('return document.documentElement.dataset.ready === "yes"'), "the page fails")
    browser.screenshot(picture)
