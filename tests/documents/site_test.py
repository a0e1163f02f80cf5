"""site_test.py TOP SITE: every link of the pages of the documents leads to a page and to a heading of it, every document of
docs has a page and can be reached from the first one, and a page of the headers that a document links to links back to it.
Without arguments the parts that make the pages are tested alone."""

import glob
import html
import os
import re
import shutil
import sys
import unittest

from header_links import link_headers, with_documents
from markdown_page import anchor, page_of, render, with_page_links

TOP, SITE = sys.argv[1:3] if len(sys.argv) > 2 else (None, None)


def text_of(page):
    with open(os.path.join(SITE, page), encoding="utf-8") as file:
        return file.read()


def links_of(page, text):
    """Pairs of a file below SITE and a name in it, without what is on the web."""
    for target in re.findall(r'(?:href|src)="([^"]*)"', text):
        if not re.match(r"[a-z]+:", target):
            path, _, name = html.unescape(target).partition("#")
            yield os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page, name


@unittest.skipUnless(SITE, "no site")
class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        paths = glob.glob(os.path.join(SITE, "**", "*.html"), recursive=True)
        pages = [os.path.relpath(path, SITE) for path in paths]
        cls.documents = {page: text_of(page) for page in pages if not page.startswith("library" + os.sep)}

    def test_every_link_leads_somewhere(self):
        wrong = []
        names = {page: set(re.findall(r' id="([^"]*)"', text)) for page, text in self.documents.items()}
        for page, text in self.documents.items():
            for path, name in links_of(page, text):
                if not os.path.isfile(os.path.join(SITE, path)) or name and name not in names.get(path, ()):
                    wrong.append(f"{page}: {path}#{name}")
        self.assertEqual(wrong, [])

    def test_every_document_is_reached_from_the_first_page(self):
        reached, waiting = set(), ["index.html"]
        while waiting:
            page = waiting.pop()
            if page in self.documents and page not in reached:
                reached.add(page)
                waiting += [path for path, _ in links_of(page, self.documents[page])]
        paths = (os.path.relpath(path, TOP) for path in glob.glob(os.path.join(TOP, "docs", "**", "*.md"), recursive=True))
        made = {page_of(path) for path in paths if not path.startswith("docs/library/")}
        self.assertGreater(len(made), 5)
        self.assertEqual(made - reached, set())

    def test_pages_of_headers_link_back(self):
        pairs = {(page, path) for page, text in self.documents.items() for path, _ in links_of(page, text)
                 if re.match(r"library/.*_8hpp\.html", path)}
        self.assertGreater(len(pairs), 50)
        wrong = [pair for pair in sorted(pairs) if pair[0] not in [path for path, _ in links_of(pair[1], text_of(pair[1]))]]
        self.assertEqual(wrong, [])

    def test_documents_that_headers_name_are_linked(self):
        for page in ("library/index.html", "library/namespacerubsweep_1_1linear.html"):
            named = {path for path, _ in links_of(page, text_of(page)) if path.startswith("docs/")}
            self.assertIn("docs/method.html", named)
            self.assertEqual(named - set(self.documents), set())

    def test_links_of_header_pages_lead_to_headings(self):
        page = "library/settle_8hpp.html"
        back = [(path, name) for path, name in links_of(page, text_of(page)) if not path.startswith("library/") and name]
        self.assertGreater(len(back), 0)
        for path, name in back:
            self.assertIn(f' id="{name}"', self.documents[path])


class Parts(unittest.TestCase):
    def test_names_of_headings(self):
        self.assertEqual(anchor("The bound behind <code>rest</code>"), "the-bound-behind-rest")
        self.assertEqual(anchor("<code>gravity_m_per_s2</code>, sweep"), "gravity_m_per_s2-sweep")

    @unittest.skipUnless(shutil.which("cmark-gfm"), "no cmark-gfm")
    def test_headings_of_one_name_are_told_apart(self):
        self.assertEqual(re.findall(r'id="([^"]*)"', render("# A b\n\n## A b\n")), ["a-b", "a-b-1"])

    def test_links_to_documents_become_links_to_pages(self):
        self.assertEqual(with_page_links('<a href="../README.md#x"><a href="a.md"><a href="https://b.org/c.md">', "docs/d.md"),
                         '<a href="../index.html#x"><a href="a.html"><a href="https://b.org/c.md">')

    def test_names_of_headers_become_links(self):
        body = '<h2 id="x">X</h2><code>response/settle.cpp</code> <code>other</code><pre><code>response/settle</code></pre>'
        linked, named = link_headers(body, {"response/settle": "settle.html"}, "../library/")
        self.assertIn('<a href="../library/settle.html"><code>response/settle.cpp</code></a>', linked)
        self.assertEqual(linked.count("<a "), 1)
        self.assertEqual(named, [(("x", "X"), "settle.html")])

    def test_a_page_of_doxygen_is_changed_once(self):
        page = '<div class="contents">\n<p>Settles as <code>docs/method.md</code> and docs/a-b.md say.</p>'
        once = with_documents(page, [("../docs/method.html#x", "Method: X")])
        self.assertIn('that name it: <a href="../docs/method.html#x">Method: X</a>', once)
        self.assertIn('as <a href="../docs/method.html"><code>docs/method.md</code></a> and <a href="../docs/a-b.html">', once)
        self.assertEqual(with_documents(once, [("../docs/method.html#x", "Method: X")]), once)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
