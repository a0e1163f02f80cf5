"""A document in Markdown as the body of a web page: rendered by cmark-gfm, as GitHub shows it, with headings that can be linked
to by the names that scripts/check_documents.sh knows, and with links to other documents as links to their pages."""

import html
import posixpath
import re
import subprocess

# Titles of these pages begin with the name of their group.
GROUPS = ("Validation", "History")


def render(text):
    """The HTML of a text, its headings with names."""
    body = subprocess.run(["cmark-gfm", "--extension", "table"], input=text, check=True, capture_output=True, text=True).stdout
    used = {}

    def named(match):
        name = anchor(match[2])
        used[name] = used.get(name, -1) + 1
        unique = name if used[name] == 0 else f"{name}-{used[name]}"
        return f'<h{match[1]} id="{unique}">{match[2]}</h{match[1]}>'

    return re.sub(r"<h([1-6])>(.*?)</h\1>", named, body, flags=re.DOTALL)


def laid_out(body, words, words_per_minute):
    """The body as a screen of any width needs it: tables in boxes that scroll, pictures that open, and below the title the time that
    reading takes, unless nobody wrote the page (0 words)."""
    body = re.sub(r"<table>.*?</table>", lambda match: f'<div class="table" tabindex="0">{match[0]}</div>', body, flags=re.DOTALL)
    body = re.sub(r"(<a [^>]*>\s*)?(<img src=\"([^\"]*)\"[^>]*>)",
                  lambda match: match[0] if match[1] else f'<a class="picture" href="{match[3]}">{match[2]}</a>', body)
    # A name in the first cell of a row may be cut behind a dot or a low line; other short code is not cut.
    body = re.sub(r"(?<=<td>)(?:– )?(?:<a [^>]*>)?<code>[^<]*</code>",
                  lambda match: re.sub(r"(?:(?<=\.)|(?<=_))(?=[^<>_.]{3}[^<>]*</code>)", "<wbr>", match[0]), body)
    # Long code is cut behind a stroke or a low line, and a number is not cut behind the minus of its power of ten.
    body = re.sub(r"<code>([^<]{31,}?)</code>(?!</pre>)", lambda match: f'<code class="long">{_with_breaks(match[1])}</code>', body)
    body = "".join(re.sub(r"(?<![\w.])\d[\d.]*e-\d+", r'<span class="whole">\g<0></span>', part) if text else part
                   for text, part in _texts(body))
    # Some pages say their time themselves.
    if not words or re.search(r"</h1>\s*<p><em>\d+ minutes", body):
        return body
    minutes = max(1, round(words / words_per_minute))
    time = f'<p class="reading">{words} words, {minutes} min</p>'
    return re.sub(r"</h1>", lambda match: f"{match[0]}\n{time}", body, count=1)


def _with_breaks(code):
    return re.sub(r"(?<=[/_])(?=\w{3})", "<wbr>", code)


def _texts(body):
    """Parts of a body, each with whether it is text and neither code nor a tag."""
    for part in re.split(r"(<pre>.*?</pre>|<code.*?</code>|<[^>]*>)", body, flags=re.DOTALL):
        yield not part.startswith("<"), part


def anchor(heading):
    """The name of a heading, given as HTML: its letters in lower case, digits, and dashes for blanks."""
    text = html.unescape(re.sub(r"<[^>]*>", "", heading)).lower()
    return re.sub(r"[^\w -]", "", text).replace(" ", "-")


def title_of(body):
    """The text of the first heading. Raises ValueError where there is none."""
    heading = re.search(r"<h1[^>]*>(.*?)</h1>", body, flags=re.DOTALL)
    if not heading:
        raise ValueError("a document without a heading")
    return html.unescape(re.sub(r"<[^>]*>", "", heading[1]))


def short_title(body):
    """The title up to a colon; behind it where this is the name of a group of pages."""
    group, _, own = title_of(body).partition(": ")
    return own[:1].upper() + own[1:] if own and group in GROUPS and not own.startswith("what") else group


def page_of(document):
    """The place of a document's page below the top of the site; the first page is that of README.md."""
    return "index.html" if document == "README.md" else posixpath.splitext(document)[0] + ".html"


def linked_files(body, document):
    """Files of the repository that a rendered document links to or shows."""
    folder = posixpath.dirname(document)
    targets = re.findall(r'(?:href|src)="([^"#]+)', body)
    return [posixpath.normpath(posixpath.join(folder, html.unescape(target))) for target in targets if "://" not in target]


def with_page_links(body, document):
    """The body with links to pages in place of those to documents."""
    folder = posixpath.dirname(document)

    def to_page(match):
        target = posixpath.normpath(posixpath.join(folder, match[1]))
        return f'href="{posixpath.relpath(page_of(target), folder or ".")}'

    return re.sub(r'href="((?![a-z]+:)[^"#]+\.md)(?=["#])', to_page, body)
