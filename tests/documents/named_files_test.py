"""named_files_test.py TOP: files that the method, the architecture and CONTRIBUTING name between backquotes are there.

A name with a slash is a place in the tree, or in a storey of the library, of `apps` or of `tests`, with or without its ending; a
name with the ending of a source alone is a file of that name anywhere. Documents that tell of earlier versions name what was.
"""

import glob
import os
import pathlib
import re
import sys
import unittest

TOP = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else ".").resolve()
FOLDERS = ("", "lib/rubsweep/core/", "lib/rubsweep/maps/", "lib/rubsweep/analysis/", "lib/rubsweep/measurement/", "lib/rubsweep/",
           "apps/", "tests/", "studies/", "configs/", "packaging/")
ENDINGS = ("", ".hpp", ".cpp", ".yaml", ".py")
NAME = re.compile(r"`((?:[A-Za-z0-9_.-]+/)+[A-Za-z0-9_.-]*|[a-z0-9_]+\.(?:hpp|cpp|sh|py))`")
# Outputs of programs, placeholders, and files of other programs.
ELSEWHERE = re.compile(r"NAME|FOLDER|STEM|^build/|^results/|^ross/|^analysis/fig_data/|^docs/examples/|^EveryStepper/|^rubsweep/detail|^detail/")


def named(text):
    """Names of files in a document, one a place."""
    return [name for name in NAME.findall(re.sub(r"\[[^\]]*\]\([^)]*\)", "", text)) if not ELSEWHERE.search(name)]


def exists(name, top):
    if "/" not in name:
        return any(True for folder in ("lib", "apps", "tests", "scripts", "studies", "packaging", "examples")
                   for _ in (top / folder).rglob(name))
    return any(glob.glob(glob.escape(str(top / (folder + name))) + ending) for folder in FOLDERS for ending in ENDINGS)


class NamedFiles(unittest.TestCase):
    def test_names_are_found_in_text_and_links_are_left_to_another_test(self):
        self.assertEqual(named("in `model/stop.hpp` and `scope/verdict`, `settle` and [a](b/c.md), `steppers.hpp`, `apps/NAME/NAME.cpp`"),
                         ["model/stop.hpp", "scope/verdict", "steppers.hpp"])
        self.assertTrue(exists("model/stop.hpp", TOP))
        self.assertFalse(exists("model/stopper.hpp", TOP))

    def test_every_named_file_is_there(self):
        pages = [TOP / "docs/architecture.md", TOP / "docs/validation.md", TOP / "CONTRIBUTING.md",
                 *sorted((TOP / "docs/method").glob("*.md")), *sorted((TOP / "docs/validation").glob("*.md"))]
        gone = [f"{page.relative_to(TOP)}: {name}" for page in pages
                for name in dict.fromkeys(named(page.read_text(encoding="utf-8"))) if not exists(name, TOP)]
        self.assertEqual(gone, [])


if __name__ == "__main__":
    unittest.main()
