"""make_site.py TOP SITE TAG_FILE: makes web pages of the documents in TOP, and writes them into SITE, where doxygen has written
the pages of the headers into the folder library and TAG_FILE beside them. Needs cmark-gfm."""

import glob
import html
import os
import posixpath
import shutil
import sys

from header_links import header_pages, link_headers, with_documents
from markdown_page import linked_files, page_of, render, title_of, with_page_links

# Pages in the order of the menu, with what they are called there. Other documents are reached by their links.
MENU = [("README.md", "Start"), ("docs/tutorial.md", "Five lessons"), ("docs/user-guide.md", "User guide"),
        ("docs/gallery.md", "Gallery"), ("docs/keys.md", "Every key"), ("docs/known-limits.md", "Known limits"),
        ("docs/other-programs.md", "Tables in other programs"),
        ("docs/method.md", "Method"), ("docs/validation.md", "Validation"), ("docs/performance.md", "Performance"),
        ("docs/other-programs.md", "Tables elsewhere"),
        ("docs/continuous-integration.md", "Hosted CI"), ("docs/for-helpers.md", "For helpers"),
        ("docs/architecture.md", "Architecture"), ("results/README.md", "Results"), ("CONTRIBUTING.md", "Contributing"),
        ("CHANGELOG.md", "Changes")]


def documents_of(top):
    """Every document by its place, rendered: those of the menu, of docs, and all that these link to."""
    waiting = [place for place, _ in MENU]
    # Pages below docs/library are doxygen's.
    waiting += sorted(place for path in glob.glob(os.path.join(top, "docs", "**", "*.md"), recursive=True)
                      if not (place := posixpath.relpath(path, top)).startswith("docs/library/"))
    bodies = {}
    while waiting:
        place = waiting.pop(0)
        if place in bodies:
            continue
        with open(os.path.join(top, place), encoding="utf-8") as file:
            bodies[place] = render(file.read())
        waiting += [linked for linked in linked_files(bodies[place], place) if linked.endswith(".md")]
    return bodies


def page(document, title, body, template):
    """A whole page, with the menu as seen from it."""
    folder = posixpath.dirname(document) or "."
    items = [("library/index.html", "Headers of the library", False)]
    items = [(page_of(place), text, place == document) for place, text in MENU] + items
    menu = "\n".join(f'<a href="{posixpath.relpath(target, folder)}"{" class=here" if here else ""}>{text}</a>'
                     for target, text, here in items)
    return (template.replace("@TITLE@", html.escape(title)).replace("@MENU@", menu).replace("@BODY@", body)
            .replace("@TOP@", posixpath.relpath(".", folder)))


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def copy_files(top, site, bodies):
    """The pictures and tables that documents link to, where they lie in the repository."""
    for document, body in bodies.items():
        for linked in linked_files(body, document):
            if os.path.isfile(os.path.join(top, linked)) and not linked.endswith(".md"):
                os.makedirs(os.path.dirname(os.path.join(site, linked)), exist_ok=True)
                shutil.copyfile(os.path.join(top, linked), os.path.join(site, linked))


def write_back_links(site, named):
    """Into every page of the headers, the links to the sections that name it."""
    for path in glob.glob(os.path.join(site, "library", "*.html")):
        with open(path, encoding="utf-8") as file:
            text = file.read()
        changed = with_documents(text, named.get(os.path.basename(path), []))
        if changed != text:
            write(path, changed)


def main(top, site, tag_file):
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "page.html"), encoding="utf-8") as file:
        template = file.read()
    pages = header_pages(tag_file)
    bodies = documents_of(top)
    named = {}
    for document, body in bodies.items():
        title = title_of(body)
        to_library = posixpath.relpath("library", posixpath.dirname(document) or ".") + "/"
        body, found = link_headers(with_page_links(body, document), pages, to_library)
        for (anchor, heading), header_page in found:
            link = (f"../{page_of(document)}#{anchor}", f"{html.escape(title.split(':')[0])}: {heading}")
            named.setdefault(header_page, []).append(link)
        write(os.path.join(site, page_of(document)), page(document, title, body, template))
    copy_files(top, site, bodies)
    shutil.copyfile(os.path.join(here, "style.css"), os.path.join(site, "style.css"))
    write_back_links(site, named)


if __name__ == "__main__":
    main(*sys.argv[1:])
