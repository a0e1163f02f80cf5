"""Texts inside gnuplot's commands."""

import re


def quoted(text):
    """`text` as gnuplot reads it between single quotes, where it knows one escape."""
    return "'" + re.sub(r"[\x00-\x1f\x7f]", "?", text).replace("'", "''") + "'"


def allowed_in_xml(text):
    """A picture as XML may be: the end of a marked section, which is none here, and characters that XML has not."""
    return re.sub("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]", "\ufffd", text).replace("]]>", "]]&gt;")
