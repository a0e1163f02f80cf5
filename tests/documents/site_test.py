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

from formula import is_formula, set_formula, with_formulas
from header_links import link_headers, with_documents
from key_links import link_names, rows_of, targets_of, with_row_names
from markdown_page import anchor, laid_out, page_of, render, short_title, with_page_links
from navigation import contents, menu, neighbours
from search_index import entries

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
            self.assertTrue(any(path.startswith("docs/method") for path in named), named)
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

    def test_code_of_the_method_is_a_formula_or_a_name(self):
        for formula in ("p", "c_r", "g1", "2 D / s", "K p", "p''", "(p, q)", "|g''| ≤ M", "step × fastest rate", "s_x = dx/dz",
                        "n floor(64 / n)"):
            self.assertTrue(is_formula(formula), formula)
        for name in ("rest", "max_order", "dopri5", "mode 1", "basin/", "response/settle", "method: exact", "--rounds",
                     "rubtrace --sample-s T", "tests/core/integrate/taylor", "contact/force_law.hpp", "audit events 600 11 thin_flats"):
            self.assertFalse(is_formula(name), name)

    def test_formulas_are_set(self):
        blank = "\u202f"  # thin, and no place for the end of a line
        for text, shown in {"c_r d'": f"<i>c</i><sub><i>r</i></sub>{blank}<i>d</i>′", "x'₊²": "<i>x</i>′<sub>+</sub><sup>2</sup>",
                            "P_(i+1)": "<i>P</i><sub><i>i</i>+1</sub>", "2e-3": "2 · 10<sup>−3</sup>",
                            "e^(−i φ)": f"<i>e</i><sup>−<i>i</i>{blank}<i>φ</i></sup>",
                            "sqrt(m)": '<span class="root">√<span><i>m</i></span></span>', "a < b": "<i>a</i> &lt; <i>b</i>",
                            "rotating_damping_ratio": "rotating_damping_ratio"}.items():
            self.assertEqual(set_formula(text, False), shown)
        fraction = '<span class="fraction"><span>{}</span><span>{}</span></span>'.format
        self.assertEqual(set_formula("x = (a + b) / (2 c)", True), "<i>x</i> = " + fraction("<i>a</i> + <i>b</i>", f"2{blank}<i>c</i>"))
        self.assertEqual(set_formula("−Im G / Re G", True), f"−{fraction('Im <i>G</i>', 'Re <i>G</i>')}".replace(" <", f"{blank}<"))
        self.assertNotIn("fraction", set_formula("(1 + c / d)", True))
        with self.assertRaises(ValueError):
            set_formula("(a", False)

    def test_formulas_stand_in_chapters_of_the_method_only(self):
        body = "<p><code>a / b</code> <code>rest</code></p><pre><code>a = b,   c\n</code></pre><pre><code>rubsweep --help\n</code></pre>"
        self.assertEqual(with_formulas(body, "docs/guide/maps.md"), body)
        seen = with_formulas(body, "docs/method/exact.md")
        self.assertIn('<span class="math short"><i>a</i> / <i>b</i></span> <code>rest</code>', seen)
        self.assertIn('<div class="formula"><span><i>a</i> = <i>b</i>,</span><span><i>c</i></span></div>', seen)
        self.assertIn("<pre><code>rubsweep --help", seen)
        lines = with_formulas("<pre><code>open    a  (b)\nclosed  c\n</code></pre>", "docs/method/contact.md")
        self.assertEqual(lines.count("<td>"), 6)
        self.assertIn("<tr><td>closed</td><td><i>c</i></td><td></td></tr>", lines)

    def test_rows_of_the_reference_can_be_linked_to(self):
        body = with_row_names("<tr>\n<td><code>rotor.mass_kg</code></td>\n<td>mass</td>\n<td>kg</td>\n</tr>\n"
                              "<tr>\n<td>– <code>rest</code></td>\n<td>at rest</td>\n</tr>\n"
                              "<tr>\n<td><code>rest</code></td>\n<td>again</td>\n</tr>\n"
                              "<tr>\n<td><code>--output DIR</code></td>\n<td>there</td>\n</tr>\n")
        self.assertEqual(rows_of(body), [("rotor.mass_kg", "mass; kg"), ("rest", "at rest")])

    def test_keys_in_code_become_links_once_in_a_section(self):
        row = "<tr>\n<td><code>{}</code></td>\n<td>x</td>\n</tr>\n"
        bodies = {"docs/reference/keys/stops.md": with_row_names(row.format("stops.N.angle_deg") + row.format("stops")),
                  "docs/reference/programs/rubsweep.md": with_row_names(row.format("speed_hz") + row.format("order"))}
        targets = targets_of(bodies)
        self.assertEqual(sorted(targets), ["speed_hz", "stops.N.angle_deg"])
        code = "<code>stops.0.angle_deg</code>"
        body = link_names(f'<h2 id="a">A</h2>{code}{code}<code>order</code><pre>{code}</pre><h2 id="b">B</h2>{code}', "docs/guide/a.md",
                          targets)
        self.assertEqual(body.count('<a class="key" href="../reference/keys/stops.html#stops.N.angle_deg">'), 2)
        self.assertEqual(body.count("<a "), 2)

    def test_a_page_fits_every_screen(self):
        body = laid_out('<h1 id="t">T</h1><table><tr></tr></table><img src="a.png" alt="A" /><a href="b"><img src="c.png" /></a>'
                        f"<code>short</code><code>{'x' * 40}</code>", 700, 200)
        self.assertIn('<h1 id="t">T</h1>\n<p class="reading">700 words, 4 min</p>', body)
        self.assertIn('<div class="table" tabindex="0"><table>', body)
        self.assertIn('<a class="picture" href="a.png"><img src="a.png"', body)
        self.assertIn('<a href="b"><img src="c.png"', body)
        self.assertEqual(body.count('<code class="long">'), 1)
        self.assertNotIn("reading", laid_out("<h1>T</h1>", 0, 200))
        self.assertNotIn("reading", laid_out("<h1>T</h1>\n<p><em>4 minutes.</em> So it begins.</p>", 700, 200))
        self.assertIn('<code class="long">tests/<wbr>core/<wbr>integrate/<wbr>dry_<wbr>friction_<wbr>test</code>',
                      laid_out("<td>x <code>tests/core/integrate/dry_friction_test</code></td>", 0, 200))
        self.assertIn('to <span class="whole">1.5e-12</span> of', laid_out("<p>to 1.5e-12 of</p>", 0, 200))
        self.assertEqual(laid_out("<code>1e-12</code>", 0, 200), "<code>1e-12</code>")
        self.assertIn("<td><code>a.N.<wbr>bcd_<wbr>efg_m</code></td>", laid_out("<td><code>a.N.bcd_efg_m</code></td>", 0, 200))

    def test_pages_of_a_section_stand_as_its_first_one_links_to_them(self):
        title = '<h1 id="{0}">{0}</h1>'.format
        bodies = {"docs/method.md": title("All") + '<a href="method/z.md">z</a><a href="method/b.md">b</a>',
                  "docs/method/a.md": title("A"), "docs/method/b.md": title("B: more"), "docs/method/z.md": title("Z")}
        seen = menu("docs/method/b.md", bodies)
        self.assertEqual(re.findall(r">([^<]+)</a>", seen), ["All", "Z", "B", "A", "Headers of the library"])
        self.assertIn('<a href="b.html" class=here aria-current=page>', seen)
        self.assertEqual(seen.count("<details open>"), 1)
        self.assertEqual(re.findall(r'href="([^"]*)"', neighbours("docs/method/b.md", bodies)), ["z.html", "a.html"])
        self.assertEqual(re.findall(r'href="([^"]*)"', neighbours("docs/method.md", bodies)), ["method/z.html"])

    def test_pages_of_a_group_are_told_apart(self):
        for title, name in {"Validation: which rub": "Which rub", "Validation: what is reproduced": "Validation",
                            "Which rub: rubdiagnose": "Which rub", "The ring": "The ring"}.items():
            self.assertEqual(short_title(f'<h1 id="x">{title}</h1>'), name)

    def test_contents_of_a_page(self):
        self.assertEqual(contents('<h2 id="a">A</h2><h2 id="b">B</h2>'), "")
        self.assertIn('<a href="#a">A b</a>', contents('<h2 id="a">A <code>b</code></h2>' * 3))

    def test_the_search_knows_sections_and_rows(self):
        body = '<h1 id="t">Title: more</h1><p>One &lt; two.</p><h2 id="s">Part</h2><p>Three.</p>'
        self.assertEqual(entries("docs/a.md", body), [["docs/a.html", "", "Title: more", "", "One < two."],
                                                      ["docs/a.html", "s", "Part", "Title", "Three."]])
        row = with_row_names("<tr>\n<td><code>speed_hz</code></td>\n<td>Hz</td>\n<td>speed</td>\n</tr>")
        self.assertIn(["docs/reference/programs/x.html", "speed_hz", "speed_hz", "X", "Hz; speed"],
                      entries("docs/reference/programs/x.md", f'<h1 id="x">X</h1>{row}'))

    def test_a_page_of_doxygen_is_changed_once(self):
        page = '<div class="contents">\n<p>Settles as <code>docs/method.md</code> and docs/a-b.md say.</p>'
        once = with_documents(page, [("../docs/method.html#x", "Method: X")])
        self.assertIn('that name it: <a href="../docs/method.html#x">Method: X</a>', once)
        self.assertIn('as <a href="../docs/method.html"><code>docs/method.md</code></a> and <a href="../docs/a-b.html">', once)
        self.assertEqual(with_documents(once, [("../docs/method.html#x", "Method: X")]), once)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
