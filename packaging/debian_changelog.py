"""debian_changelog.py VERSION TOP OUTPUT: a changelog in Debian's format, of the version in the checkout TOP.

It says where the changes are listed; its date is that of the last commit, or of CHANGELOG.md where there is none.
"""

import email.utils
import os
import subprocess
import sys


def text(version, seconds):
    """The changelog of a version of this date, in seconds since 1970."""
    return (f"rubsweep ({version}) bookworm; urgency=medium\n\n"
            "  * Built by the project itself; the changes are listed in CHANGELOG.md.\n\n"
            f" -- The rubsweep developers <developers@rubsweep.invalid>  {email.utils.formatdate(seconds)}\n")


def date_of(top):
    """Date of the last commit of TOP in seconds since 1970; without one, that of its list of changes."""
    asked = subprocess.run(["git", "-C", top, "log", "-1", "--format=%ct"], capture_output=True, text=True)
    if asked.returncode == 0 and asked.stdout.strip():
        return int(asked.stdout)
    return int(os.stat(os.path.join(top, "CHANGELOG.md")).st_mtime)


def main(arguments):
    version, top, output = arguments
    with open(output, "w", encoding="utf-8") as file:
        file.write(text(version, date_of(top)))


if __name__ == "__main__":
    main(sys.argv[1:])
