"""Formulas of the method, which its documents write as plain text in code: set in italics, with indices, powers, roots and, where a
formula stands alone, fractions. No script and no other font is needed."""

import html
import re

# Documents in which code may be a formula.
OF_METHOD = "docs/method/"

_FUNCTIONS = {"sqrt", "exp", "ln", "log", "cos", "sin", "tanh", "atan", "det", "max", "min", "Re", "Im", "conj", "floor", "binomial"}
_SYMBOLS = {"pi": "π", "mu": "μ", "<=": "≤", ">=": "≥", "-": "−", "'": "′", "...": "…"}
_RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ᵀᴴ", "0123456789+−TH")) | {"ⁿ": "<i>n</i>", "ⁱ": "<i>i</i>", "ᵃ": "<i>a</i>"}
_LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋.", "0123456789+−."))
_RAISED_CLASS, _LOWERED_CLASS = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿⁱᵃᵀᴴ", "₀₁₂₃₄₅₆₇₈₉₊₋"
_GREEK = "α-ωΑ-Ω"
_TOKEN = re.compile(rf"""(?P<blank>\s+)|(?P<number>\d+(?:\.\d+)?(?:e[-−]?\d+|X)?)|(?P<word>[A-Za-z]+(?:_[A-Za-z]{{2,}})*|[{_GREEK}])
    |(?P<raised>[{_RAISED_CLASS}]+)|(?P<lowered>[{_LOWERED_CLASS}](?:[{_LOWERED_CLASS}.]*[{_LOWERED_CLASS}])?)
    |(?P<sign>\.\.\.|<=|>=|\S)""", re.VERBOSE)
_CLOSING = {"(": ")", "[": "]", "|": "|"}
# Signs before which the numerator of a fraction begins.
_BETWEEN = set("=≤≥<>+−±,;:")


def is_formula(code):
    """Whether code of the method is a formula and no name of a file, key, option or command."""
    if re.search(r"--|: |::|[{}\"\\]|/$|[a-z_]{3,}/[a-z_]{3,}|\.(?:hpp|cpp|csv|md|txt|py|yaml)\b", code):
        return False
    if re.search(rf"[=<>≤≥+−×·^()|'!±{_GREEK}{_RAISED_CLASS}{_LOWERED_CLASS}]", code):
        return True
    return all(len(word) == 1 for word in re.findall(r"[A-Za-z]+(?=_|\b)|[A-Za-z_]{2,}", re.sub(r"_\w\b", "", code)))


class _Parser:
    """A formula as a list of pieces of HTML, in which blanks and signs are marked, so that fractions can be found."""

    def __init__(self, text, alone):
        self.tokens = [(match.lastgroup, match[0]) for match in _TOKEN.finditer(text)]
        self.at = 0
        self.alone = alone

    def sequence(self, end=None):
        """Pieces up to the closing bracket `end`, which is taken, too. Raises ValueError where there is none."""
        pieces = []
        while self.at < len(self.tokens):
            if end and self.tokens[self.at] == ("sign", end):
                self.at += 1
                return pieces
            pieces.append(self.piece())
        if end:
            raise ValueError(f"no {end}")
        return pieces

    def piece(self):
        kind, text = self.tokens[self.at]
        self.at += 1
        if kind == "blank":
            return "blank", " "
        if kind == "sign" and text in _CLOSING:
            inner = self.inside(_CLOSING[text])
            # Brackets around a whole numerator or denominator are taken away where the bar of the fraction tells as much.
            scripts = self.scripts()
            return ("group" if text == "(" and not scripts else "atom"), f"{text}{inner}{_CLOSING[text]}{scripts}"
        if kind == "sign" and text == "'":
            return "word", "’"
        if kind == "sign":
            return "sign", html.escape(_SYMBOLS.get(text, text))
        if kind == "word" and text == "sqrt" and self.next() == "(":
            self.at += 1
            inner = self.inside(")")
            return "atom", f'<span class="root">√<span>{inner}</span></span>{self.scripts()}'
        shown = self.name(text) if kind == "word" else self.number(text) if kind == "number" else self.other(kind, text)
        # A stroke behind a word is an apostrophe, behind a letter it is a derivative.
        scripts = "" if kind == "word" and len(text) > 2 and self.next() == "'" else self.scripts()
        # Brackets right behind a name are its arguments.
        if self.next() == "(":
            self.at += 1
            scripts += f"({self.inside(')')}){self.scripts()}"
        plain = kind == "word" and len(text) > 1 and not scripts and not re.fullmatch("d[a-z]", text)
        return ("function" if plain and text in _FUNCTIONS else "word" if plain else "atom"), shown + scripts

    def inside(self, end):
        """What stands in brackets, where a stroke stays a stroke: brackets do not grow."""
        alone, self.alone = self.alone, False
        inner = self.shown(self.sequence(end))
        self.alone = alone
        return inner

    def next(self):
        return self.tokens[self.at][1] if self.at < len(self.tokens) else ""

    def name(self, text):
        if text in _SYMBOLS:
            return f"<i>{_SYMBOLS[text]}</i>"
        if re.fullmatch("d[a-z]", text):
            return f"d<i>{text[1]}</i>"
        if len(text) == 1:
            digits = ""
            if text.isascii() and re.fullmatch(r"\d", self.next()):
                digits = f"<sub>{self.next()}</sub>"
                self.at += 1
            return (text if text in "ΣΦΩ" else f"<i>{text}</i>") + digits
        indexed = re.fullmatch("([A-Za-z])_([a-z]+)", text)
        return f"<i>{indexed[1]}</i><sub>{indexed[2]}</sub>" if indexed else html.escape(text)

    @staticmethod
    def number(text):
        mantissa, _, power = text.partition("e")
        if not power:
            return text
        return ("" if mantissa == "1" else f"{mantissa} · ") + f"10<sup>{power.replace('-', '−')}</sup>"

    @staticmethod
    def other(kind, text):
        if kind == "raised":
            return f"<sup>{''.join(map(_RAISED.get, text))}</sup>"
        if kind == "lowered":
            return f"<sub>{''.join(map(_LOWERED.get, text))}</sub>"
        return html.escape(_SYMBOLS.get(text, text))

    def scripts(self):
        """Primes, indices and powers that follow."""
        found = ""
        while self.at < len(self.tokens):
            kind, text = self.tokens[self.at]
            if kind in ("raised", "lowered") or (kind, text) in (("sign", "'"), ("sign", "!")):
                found += self.other(kind, text)
                self.at += 1
            elif kind == "sign" and text in "_^" and self.at + 1 < len(self.tokens):
                self.at += 1
                found += self.script("sub" if text == "_" else "sup")
            else:
                break
        return found

    def script(self, tag):
        kind, text = self.tokens[self.at]
        self.at += 1
        if (kind, text) == ("sign", "("):
            inner = self.inside(")")
        else:
            inner = self.name(text) if kind == "word" else self.number(text) if kind == "number" else self.other(kind, text)
        return f"<{tag}>{inner}</{tag}>"

    def shown(self, pieces):
        if self.alone:
            pieces = with_fractions(pieces)
        parts = []
        for i, (kind, text) in enumerate(pieces):
            if kind == "blank":
                around = {pieces[i - 1][0] if i else "", pieces[i + 1][0] if i + 1 < len(pieces) else ""}
                # A product has a thin blank; lines break at signs and between words only.
                text = " " if around & {"word", "sign"} else "\u202f"
            parts.append(text)
        return "".join(parts)


def with_fractions(pieces):
    """The pieces with a / b, where blanks stand around the stroke, as one above the other."""
    found = []
    i = 0
    while i < len(pieces):
        if pieces[i] == ("sign", "/") and found and found[-1][0] == "blank" and i + 2 < len(pieces) and pieces[i + 1][0] == "blank":
            found.pop()
            over = []
            while found and not (found[-1][0] == "sign" and found[-1][1] in _BETWEEN) and found[-1][0] != "word":
                over.insert(0, found.pop())
            while over and over[0][0] == "blank":
                found.append(over.pop(0))
            i += 2
            under = []
            while i < len(pieces) and pieces[i] not in (("sign", ","), ("sign", ".")):
                if pieces[i][0] == "blank" and under[-1][0] != "function":
                    break
                under.append(pieces[i])
                i += 1
            bare = lambda part: part[0][1][1:-1] if len(part) == 1 and part[0][0] == "group" else _Parser("", False).shown(part)
            found.append(("atom", f'<span class="fraction"><span>{bare(over)}</span><span>{bare(under)}</span></span>'))
            continue
        found.append(pieces[i])
        i += 1
    return found


def set_formula(text, alone):
    """A formula as HTML; `alone`: it stands in a line of its own. Raises ValueError where its brackets do not match."""
    parser = _Parser(text, alone)
    return parser.shown(parser.sequence())


def _block(text):
    """Lines of formulas; what is set apart by two blanks or more and begins at the same place stands in one column."""
    lines = [[(match.start(), match[0]) for match in re.finditer(r"\S+(?: \S+)*", line)] for line in text.rstrip("\n").split("\n")]
    if len(lines) == 1:
        return '<div class="formula">' + "".join(f"<span>{set_formula(part, True)}</span>" for _, part in lines[0]) + "</div>"
    places = sorted({place for line in lines for place, _ in line})
    rows = []
    for line in lines:
        cells = dict(line)
        rows.append("".join(f"<td>{set_formula(cells[place], True) if place in cells else ''}</td>" for place in places))
    return '<div class="formula"><table class="formula">' + "".join(f"<tr>{row}</tr>" for row in rows) + "</table></div>"


def with_formulas(body, document):
    """The body of a page; in chapters of the method, code that is a formula is set as one."""
    if not document.startswith(OF_METHOD):
        return body

    def in_text(match):
        code = html.unescape(match[1])
        if not is_formula(" ".join(code.split())):
            return match[0]
        try:
            short = " short" if len(code) < 31 else ""
            return f'<span class="math{short}">{set_formula(" ".join(code.split()), False)}</span>'
        except ValueError:
            return match[0]

    def in_block(match):
        text = html.unescape(match[1])
        if re.search(r"--|[{}\\]", text):
            return match[0]
        try:
            return _block(text)
        except ValueError:
            return match[0]

    body = re.sub(r"<pre><code>(.*?)</code></pre>", in_block, body, flags=re.DOTALL)
    return re.sub(r"<code>([^<]*)</code>", in_text, body)
