"""How a picture can fail to come about, apart from damaged tables and configurations."""

import os


class Failure(Exception):
    """A file or a program that cannot be used; the message names it."""


class WrongCall(Exception):
    """A command line that asks for what there is not; the message says what is allowed."""


def require_readable(*paths):
    """Raises Failure for the first of the files that cannot be read."""
    for path in paths:
        if not os.access(path, os.R_OK) or os.path.isdir(path):
            raise Failure(f"cannot read {path}")
