"""Labels beside an axis in rows of their own, so that none stands on another."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Label:
    text: str
    at: float  # what it names, as a share of the axis
    middle: float  # where it stands, as a share of the axis
    row: int  # 0: next to what is named


def joined(named, same=1e-6):
    """(share, text) with those at one place joined: probe 0, probe 1 -> probe 0, 1."""
    groups = []
    for share, text in sorted(named, key=lambda one: one[0]):
        if groups and abs(groups[-1][0] - share) <= same:
            groups[-1][1].append(text)
        else:
            groups.append((share, [text]))
    return [(share, _list(texts)) for share, texts in groups]


def _list(texts):
    first = texts[0].rpartition(" ")[0]
    if len(texts) > 1 and first and all(text.rpartition(" ")[0] == first for text in texts):
        return f"{first} " + ", ".join(text.rpartition(" ")[2] for text in texts)
    return ", ".join(texts)


def lay_out(named, letter, gap=1.0):
    """Labels of (share, text), each in the row nearest to what it names in which it touches no other; `letter` is the width
    of a letter as a share of the axis, `gap` the least distance in letters."""
    ends = []  # right end of each row
    labels = []
    for share, text in joined(named):
        width = letter * len(text)
        middle = min(max(share, width / 2), max(1 - width / 2, width / 2))
        row = next((i for i, end in enumerate(ends) if end + gap * letter <= middle - width / 2), len(ends))
        if row == len(ends):
            ends.append(0.0)
        ends[row] = middle + width / 2
        labels.append(Label(text, share, middle, row))
    return labels


def rows(labels):
    """The number of rows of some labels."""
    return max((label.row + 1 for label in labels), default=0)
