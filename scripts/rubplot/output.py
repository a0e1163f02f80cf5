"""The files that a picture is written to, by --output and --formats."""

import os
import shutil
import tempfile

from rubplot.failure import WrongCall

FORMATS = ("png", "svg", "pdf")
DEFAULT_FORMATS = ("png", "svg")
# Endings that a person takes for a format; any other one is a part of the name.
_OTHER_FORMATS = ("bmp", "eps", "gif", "jpeg", "jpg", "ps", "tif", "tiff", "webp")


def read_formats(text):
    """The formats of a list like "png,pdf". Raises WrongCall."""
    formats = [word.strip().lower() for word in text.split(",")]
    for word in formats:
        if word not in FORMATS:
            raise WrongCall(f"--formats: '{word}' is not allowed, allowed: {', '.join(FORMATS)}")
    return tuple(dict.fromkeys(formats))


def targets(output, formats=None):
    """A dict from each format to the absolute name of its file: the one that the ending of `output` names, else all of
    `formats` with their endings behind the name. Raises WrongCall."""
    ending = os.path.splitext(output)[1][1:].lower()
    if ending in _OTHER_FORMATS:
        raise WrongCall(f"--output {output}: allowed: a name that ends with .png, .svg or .pdf, or one without ending")
    if not os.path.basename(output) or os.path.isdir(output):
        raise WrongCall(f"--output {output}: is a directory, allowed: the name of a file")
    path = os.path.abspath(output)
    if ending in FORMATS:
        if formats is not None and tuple(formats) != (ending,):
            raise WrongCall(f"--formats: belongs to an --output without ending, {output} is a {ending} file")
        return {ending: path}
    return {name: f"{path}.{name}" for name in formats or DEFAULT_FORMATS}


def place(drawn, path):
    """Copies a picture to its name, whole or not at all; its directory is made."""
    _replace(path, lambda partial: shutil.copyfile(drawn, partial))


def place_text(text, path):
    """Writes a text to its name likewise."""
    _replace(path, lambda partial: _write(text, partial))


def _write(text, path):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _replace(path, write):
    """Lets `write` fill a file beside `path`, which then gets its name."""
    directory = os.path.dirname(path)
    os.makedirs(directory, exist_ok=True)
    handle, partial = tempfile.mkstemp(prefix=".rubplot-", dir=directory)
    os.close(handle)
    try:
        write(partial)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(partial, 0o666 & ~mask)
        os.replace(partial, path)
    except OSError as error:
        os.unlink(partial)
        if error.filename in (None, partial):
            raise OSError(error.errno, error.strerror, path) from None
        raise
