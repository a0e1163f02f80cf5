"""Links between documents and the pages that doxygen makes of the headers: a name of a header or of a folder of lib/rubsweep
in a document leads to its page, and that page names the sections from where it is named."""

import html
import posixpath
import re
import xml.etree.ElementTree as ElementTree

_BEGIN, _END = "<!-- documents -->", "<!-- end of documents -->"


def header_pages(tag_file):
    """Pages by what documents call them, such as core/response/settle, response/settle and response, of doxygen's tag file."""
    pages = {}
    for compound in ElementTree.parse(tag_file).getroot().iter("compound"):
        name, path, page = (compound.findtext(part) or "" for part in ("name", "path", "filename"))
        if compound.get("kind") == "file" and name.endswith(".hpp"):
            place = posixpath.splitext(path + name)[0]
        elif compound.get("kind") == "dir":
            place = path.rstrip("/") or name
        else:
            continue
        place = place[place.index("rubsweep/"):] if "rubsweep/" in place else place
        place = place.removeprefix("rubsweep/")
        # Documents name a folder with its storey or without.
        for name in {place, re.sub("^(core|maps|analysis|measurement)/", "", place)}:
            pages[name] = page if page.endswith(".html") else page + ".html"
    return pages


def link_headers(body, pages, to_library):
    """The body with links to `to_library` + page, and the pairs of section and page: where each page is named first."""
    named = {}
    parts = []
    section = ("", "")
    # Code inside a link or a block of code stays as it is.
    for part in re.split(r"(<h[1-6] id=.*?</h[1-6]>|<pre>.*?</pre>|<a .*?</a>|<code>[^<]*</code>)", body, flags=re.DOTALL):
        heading = re.match(r'<h[1-6] id="([^"]*)">(.*)</h', part, flags=re.DOTALL)
        code = re.fullmatch(r"<code>(?:lib/rubsweep/)?([\w/]+?)/?(?:\.[hc]pp)?</code>", part)
        if heading:
            section = (heading[1], re.sub(r"<[^>]*>", "", heading[2]))
        elif code and "/" in part[:-len("</code>")] and code[1] in pages:
            page = pages[code[1]]
            named.setdefault((page, section), None)
            part = f'<a href="{html.escape(to_library + page)}">{part}</a>'
        parts.append(part)
    return "".join(parts), [(section, page) for page, section in named]


def with_documents(page, links):
    """The text of a page of doxygen's, which says in its first line where the documents are and which of them name it, and
    links to a document where it names one. `links` are pairs of address and text."""
    unlinked = r'(?<!\.html">)(?<!\.html"><code>)(<code>)?docs/((?:[\w-]+/)*[\w-]+)\.md(?(1)</code>)'
    page = re.sub(unlinked, r'<a href="../docs/\2.html">\g<0></a>', page)
    page = re.sub(f"{_BEGIN}.*?{_END}\n", "", page, flags=re.DOTALL)
    listed = ", ".join(f'<a href="{address}">{text}</a>' for address, text in links)
    line = f'{_BEGIN}<p><a href="../index.html">Documents</a>{f" that name it: {listed}" if listed else ""}</p>{_END}\n'
    return page.replace('<div class="contents">\n', f'<div class="contents">\n{line}', 1)
