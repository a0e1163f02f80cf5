"""Names in the reference (keys, columns, words in columns) and the links from other pages to their meaning."""

import html
import posixpath
import re

from markdown_page import page_of

REFERENCE = "docs/reference/"
# Tables whose columns and words are meant where only their name is said.
OF_MAPS = REFERENCE + "programs/rubsweep.md"


def with_row_names(body):
    """A page of the reference whose rows can be linked to by the name in their first cell; the first of several rows has it."""
    used = set()

    def named(match):
        name = html.unescape(match[2])
        if name in used or not re.fullmatch(r"[\w.+-]+", name):
            return match[0]
        used.add(name)
        return f'<tr id="{name}">\n<td>{match[1]}<code>{match[2]}</code></td>'

    return re.sub(r"<tr>\n<td>((?:– )?)<code>([^<]*)</code></td>", named, body)


def rows_of(body):
    """Pairs of name and text of the rows that can be linked to, without the name."""
    cells = lambda row: [cell for cell in map(text_of, row.split("</td>")[1:]) if cell]
    return [(html.unescape(name), "; ".join(cells(row))) for name, row in re.findall(r'<tr id="([^"]*)">(.*?)</tr>', body, flags=re.DOTALL)]


def text_of(part):
    """The text of a part of a page in one line."""
    return " ".join(html.unescape(re.sub(r"<[^>]*>", " ", part)).split())


def targets_of(bodies):
    """Page and anchor of each name: of every key, and of columns and words of a map that have an underscore, so that no everyday
    word is taken for one."""
    targets = {}
    for place, body in bodies.items():
        if place.startswith(REFERENCE + "keys/") or place == "docs/keys.md":
            for name, _ in rows_of(body):
                if "." in name or "_" in name:
                    targets.setdefault(name, (page_of(place), name))
    for name, _ in rows_of(bodies.get(OF_MAPS, "")):
        if "_" in name:
            targets.setdefault(name, (page_of(OF_MAPS), name))
    return targets


def link_names(body, document, targets):
    """The body with links to the meaning of names in code, the first time in each section."""
    folder = posixpath.dirname(document) or "."
    seen, parts = set(), []
    for part in re.split(r"(<h[1-6] .*?</h[1-6]>|<pre>.*?</pre>|<a .*?</a>|<code>[^<]*</code>)", body, flags=re.DOTALL):
        code = re.fullmatch(r"<code>([\w.]+)(?:: [^<]*)?</code>", part)
        # Numbers in a list stand for any.
        name = re.sub(r"(?<=\.)\d+(?=\.|$)", "N", code[1]) if code else ""
        if part.startswith("<h2"):
            seen.clear()
        if name in targets and name not in seen:
            seen.add(name)
            page, anchor = targets[name]
            part = f'<a class="key" href="{posixpath.relpath(page, folder)}#{html.escape(anchor)}">{part}</a>'
        parts.append(part)
    return "".join(parts)
