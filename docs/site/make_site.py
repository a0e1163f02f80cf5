"""make_site.py TOP SITE TAG_FILE: makes web pages of the documents in TOP, and writes them into SITE, where doxygen has written
the pages of the headers into the folder library and TAG_FILE beside them. Needs cmark-gfm."""

import glob
import html
import os
import posixpath
import shutil
import sys

from formula import with_formulas
from header_links import header_pages, link_headers, with_documents
from key_links import REFERENCE, link_names, targets_of, with_row_names
from markdown_page import laid_out, linked_files, page_of, render, title_of, with_page_links
from navigation import SECTIONS, all_documents, contents, menu, neighbours
from search_index import search_index


def documents_of(top):
    """Every document by its place, rendered: those of the menu, of docs, and all that these link to; and the text of each."""
    waiting = [place for section in SECTIONS for place in section.first + section.last
               if os.path.isfile(os.path.join(top, place))] + all_documents(top)
    bodies, texts = {}, {}
    while waiting:
        place = waiting.pop(0)
        if place in bodies:
            continue
        with open(os.path.join(top, place), encoding="utf-8") as file:
            texts[place] = file.read()
        bodies[place] = render(texts[place])
        if place.startswith(REFERENCE) or place == "docs/keys.md":
            bodies[place] = with_row_names(bodies[place])
        waiting += [linked for linked in linked_files(bodies[place], place) if linked.endswith(".md")]
    return bodies, texts


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


def clear(site):
    """Takes away the pages of an earlier call, some of which may be of documents that are gone."""
    for name in os.listdir(site) if os.path.isdir(site) else []:
        path = os.path.join(site, name)
        if name != "library" and os.path.isdir(path):
            shutil.rmtree(path)


def main(top, site, tag_file):
    here = os.path.dirname(os.path.abspath(__file__))
    sys.path.insert(0, os.path.join(top, "scripts"))
    from document_words import WORDS_PER_MINUTE, words  # pylint: disable=import-outside-toplevel
    with open(os.path.join(here, "page.html"), encoding="utf-8") as file:
        template = file.read()
    pages = header_pages(tag_file)
    bodies, texts = documents_of(top)
    targets = targets_of(bodies)
    named = {}
    clear(site)
    for document, body in bodies.items():
        title = title_of(body)
        folder = posixpath.dirname(document) or "."
        generated = document.startswith(REFERENCE) or document == "CHANGELOG.md"
        body = with_formulas(with_page_links(body, document), document)
        body, found = link_headers(body, pages, posixpath.relpath("library", folder) + "/")
        if document not in ("docs/keys.md",) and not document.startswith(REFERENCE):
            body = link_names(body, document, targets)
        for (anchor, heading), header_page in found:
            link = (f"../{page_of(document)}#{anchor}", f"{html.escape(title.split(':')[0])}: {heading}")
            named.setdefault(header_page, []).append(link)
        parts = {"TITLE": html.escape(title), "TOP": posixpath.relpath(".", folder), "MENU": menu(document, bodies),
                 "NEIGHBOURS": neighbours(document, bodies), "CONTENTS": contents(body),
                 "BODY": laid_out(body, 0 if generated else words(texts[document]), WORDS_PER_MINUTE)}
        page = template
        for name, part in parts.items():
            page = page.replace(f"@{name}@", part)
        write(os.path.join(site, page_of(document)), page)
    copy_files(top, site, bodies)
    for name in ("style.css", "site.js"):
        shutil.copyfile(os.path.join(here, name), os.path.join(site, name))
    write(os.path.join(site, "search_index.js"), search_index(bodies))
    write_back_links(site, named)


if __name__ == "__main__":
    main(*sys.argv[1:])
