"""Title, author and note of a configuration, as pictures show them. All of them may be missing."""

from rubplot import configuration

LONGEST = 160  # letters of a line that a picture has room for
WORDS = ("title", "author", "note")


def title(config):
    return _text(config, "title")


def byline(config):
    """Author and the first line of the note."""
    lines = _text(config, "note").splitlines()
    text = ": ".join(part for part in (_text(config, "author"), lines[0] if lines else "") if part)
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"


def headed(heading, config):
    """A heading behind the title of the configuration."""
    return ": ".join(part for part in (title(config), heading) if part)


def of_table(head):
    """The captions in the head of a table (csv_table.head), as a configuration would hold them."""
    return {word: configuration.quoted(head[word]) for word in WORDS if head.get(word)}


def _text(config, key):
    return configuration.text(config.get(key, ""))
