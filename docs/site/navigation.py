"""Sections of the menu, their pages in order, and the page before and behind another one."""

import html
import os
import posixpath
import re
from dataclasses import dataclass, field
from typing import List

from markdown_page import linked_files, page_of, short_title


@dataclass
class Section:
    """`first` and `last` are documents that stand before and behind those of the folder, which come in the order in which the first
    document of the section links to them; `in_a_row`: pages lead to the next one."""

    name: str
    first: List[str] = field(default_factory=list)
    folder: str = ""
    last: List[str] = field(default_factory=list)
    in_a_row: bool = False


SECTIONS = [
    Section("Start", ["README.md"]),
    Section("Tutorial", ["docs/tutorial.md", "docs/gallery.md"]),
    Section("Guide", ["docs/user-guide.md"], "docs/guide",
            ["docs/known-limits.md", "docs/other-programs.md", "docs/continuous-integration.md", "docs/for-helpers.md"], in_a_row=True),
    Section("Reference", ["docs/reference/README.md", "docs/keys.md"], "docs/reference"),
    Section("Method", ["docs/method.md"], "docs/method", in_a_row=True),
    Section("Validation and performance", ["docs/validation.md"], "docs/validation", ["docs/performance.md", "results/README.md"]),
    Section("Developers", ["docs/architecture.md", "CONTRIBUTING.md"], "", ["library/index.html"]),
    Section("History", [], "docs/history", ["CHANGELOG.md"]),
]
# Pages of the headers are no documents, and pages of single keys are many: the page of keys leads to them.
NAMES = {"README.md": "What it is", "library/index.html": "Headers of the library", "docs/tutorial.md": "Tutorial"}
LEFT_OUT = "docs/reference/keys/"


def pages_of(section, bodies):
    """Documents of a section in the order of the menu."""
    first = [place for place in section.first if place in bodies]
    inside = [place for place in bodies if section.folder and place.startswith(section.folder + "/") and place not in first
              and not place.startswith(LEFT_OUT)]
    linked = [one for place in first for one in linked_files(bodies[place], place)]
    inside.sort(key=lambda place: (linked.index(place) if place in linked else len(linked), place))
    return [*first, *inside, *(place for place in section.last if place in bodies or place in NAMES)]


def name_of(place, bodies):
    """What a page is called in the menu."""
    return NAMES.get(place) or short_title(bodies[place])


def target_of(place):
    return place if place.endswith(".html") else page_of(place)


def menu(document, bodies):
    """The menu as seen from a document, the section of which is open."""
    folder = posixpath.dirname(document) or "."
    parts = []
    for section in SECTIONS:
        places = pages_of(section, bodies)
        here = document in places or bool(section.folder) and document.startswith(section.folder + "/")
        links = "\n".join(f'<a href="{posixpath.relpath(target_of(place), folder)}"'
                          f'{" class=here aria-current=page" if place == document else ""}>{html.escape(name_of(place, bodies))}</a>'
                          for place in places)
        if places:
            parts.append(f"<details{' open' if here else ''}><summary>{section.name}</summary>\n{links}\n</details>")
    return "\n".join(parts)


def neighbours(document, bodies):
    """Links to the page before and to the next one; empty where pages stand alone."""
    for section in SECTIONS:
        places = pages_of(section, bodies) if section.in_a_row else []
        if document not in places:
            continue
        i, folder = places.index(document), posixpath.dirname(document) or "."
        found = [(places[k], kind, word) for k, kind, word in ((i - 1, "previous", "Before"), (i + 1, "next", "Next"))
                 if 0 <= k < len(places)]
        links = "\n".join(f'<a class="{kind}" rel="{"prev" if kind == "previous" else kind}" '
                          f'href="{posixpath.relpath(target_of(place), folder)}"><small>{word}</small>'
                          f'{html.escape(name_of(place, bodies))}</a>' for place, kind, word in found)
        return f'<div class="neighbours">\n{links}\n</div>'
    return ""


def contents(body):
    """What is on a page: its headings of the second rank; empty where there are fewer than three."""
    headings = re.findall(r'<h2 id="([^"]*)">(.*?)</h2>', body, flags=re.DOTALL)
    links = "\n".join(f'<a href="#{anchor}">{re.sub("<[^>]*>", "", text)}</a>' for anchor, text in headings)
    return f"<p>On this page</p>\n{links}" if len(headings) > 2 else ""


def all_documents(top):
    """Places of all documents of docs but doxygen's, in order."""
    found = []
    for folder, _, files in sorted(os.walk(os.path.join(top, "docs"))):
        place = posixpath.relpath(folder, top)
        if place != "docs/library":
            found += [posixpath.join(place, name) for name in sorted(files) if name.endswith(".md")]
    return found
