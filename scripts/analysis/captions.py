"""Title, author and note of a configuration, as pictures show them. All of them may be missing."""

import json

LONGEST = 160  # letters of a line that a picture has room for


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


def _text(config, key):
    """Plain words stand as they are, others in double quotes, as in JSON but for bytes by number."""
    value = config.get(key, "")
    if not value.startswith('"'):
        return value
    return json.loads(value.replace("\\x", "\\u00"))
