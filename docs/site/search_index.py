"""The index of the search: for each section of each page its address, title and text, and for each row of the reference."""

import json
import re

from key_links import REFERENCE, rows_of, text_of
from markdown_page import page_of, short_title


def sections_of(body):
    """Triples of anchor, heading and text of the parts of a page that begin with a heading."""
    pieces = re.split(r'<h[1-4] id="([^"]*)">(.*?)</h[1-4]>', body, flags=re.DOTALL)
    return [(pieces[i], text_of(pieces[i + 1]), text_of(pieces[i + 2])) for i in range(1, len(pieces) - 2, 3)]


def entries(document, body):
    """Lists of page, anchor, title, the page's own name, and text."""
    page, name = page_of(document), short_title(body)
    found = [[page, "" if i == 0 else anchor, heading, name if i else "", text]
             for i, (anchor, heading, text) in enumerate(sections_of(body))]
    if document.startswith(REFERENCE) or document == "docs/keys.md":
        # The rows tell what the tables would; pages that list what others explain would only hide these.
        found = [[*entry[:4], re.sub(r"\s+", " ", entry[4])[:300]] for entry in found]
        if not document.endswith(("/columns.md", "/words.md", "/files.md")):
            found += [[page, row, row, name, text] for row, text in rows_of(body)]
    return found


def search_index(bodies):
    """The script that hands the index to the search."""
    listed = [entry for document, body in bodies.items() for entry in entries(document, body)]
    return "window.rubsweepSearchIndex = " + json.dumps(listed, ensure_ascii=False, separators=(",", ":")) + ";\n"
