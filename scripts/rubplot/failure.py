"""How a picture can fail to come about, apart from damaged tables and configurations."""

import os
import stat


class Failure(Exception):
    """A file or a program that cannot be used; the message names it."""


class WrongCall(Exception):
    """A command line that asks for what there is not; the message says what is allowed."""


def open_regular(path, mode="r", **settings):
    """As open, of a regular file: nobody can tell how long a pipe or a device would keep its reader waiting. Raises Failure."""
    handle = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    kind = os.fstat(handle).st_mode
    if not stat.S_ISREG(kind) and not stat.S_ISDIR(kind):  # open says of a directory what it is
        os.close(handle)
        raise Failure(f"cannot read {path}: it is not a regular file")
    return open(handle, mode, **settings)


def require_readable(*paths):
    """Raises Failure for the first of the files that cannot be read."""
    for path in paths:
        if not os.access(path, os.R_OK) or os.path.isdir(path):
            raise Failure(f"cannot read {path}")
