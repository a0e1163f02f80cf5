"""Texts inside gnuplot's commands."""

import re


def quoted(text):
    """`text` as gnuplot reads it between single quotes, where it knows one escape."""
    return "'" + re.sub(r"[\x00-\x1f\x7f]", "?", text).replace("'", "''") + "'"
