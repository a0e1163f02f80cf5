"""Screen of somebody who types into bash: options, kinds of templates and files completed by the tabulator, and
the manual page. Ends with 1 where something else is shown. In a directory with my.yaml, with the programs in PATH and with
bash-completion and man-db installed."""

import os
import pty
import re
import select
import sys
import tempfile
import time

_SETUP = """
PS1='$ '
source /usr/share/bash-completion/bash_completion
bind 'set enable-bracketed-paste off'; bind 'set bell-style none'; bind 'set completion-query-items 0'
stty cols 100
echo begun
"""


class Terminal:
    """A bash in a pseudo terminal."""

    def __init__(self):
        self._rc = tempfile.NamedTemporaryFile("w", suffix=".bashrc")
        self._rc.write(_SETUP)
        self._rc.flush()
        child, self._end = pty.fork()
        if child == 0:
            os.environ["TERM"] = "dumb"
            os.execvp("bash", ["bash", "--noprofile", "--rcfile", self._rc.name, "-i"])
        self._until("begun\n$ ")

    def types(self, keys, shown):
        """Sends keys and returns the screen from there on, which must come to hold a text."""
        os.write(self._end, keys.encode())
        return self._until(shown)

    def clears_line(self):
        self.types("\x15\n", "\n$ ")

    def _until(self, shown, seconds=60):
        screen, last = "", time.monotonic() + seconds
        while shown not in screen:
            if not select.select([self._end], [], [], max(0.0, last - time.monotonic()))[0]:
                sys.exit(f"the terminal does not show {shown!r} but:\n{screen}")
            screen += os.read(self._end, 65536).decode("utf-8", "replace")
            screen = re.sub(r"\x1b\[[0-9;?]*[A-Za-z]|\r|\x07", "", screen)
        return screen


def main():
    terminal = Terminal()
    print("$ rubsweep --ini<Tab>")
    print("$ " + terminal.types("rubsweep --ini\t", "rubsweep --init "))
    print("$ rubsweep --init <Tab><Tab>" + terminal.types("\t\t", "rotor_kit").rstrip())
    terminal.clears_line()
    print("$ rubsweep my.y<Tab>")
    print("$ " + terminal.types("rubsweep my.y\t", "rubsweep my.yaml "))
    terminal.clears_line()
    print("$ rubtrace my.yaml --set stops.0.cl<Tab>")
    print("$ " + terminal.types("rubtrace my.yaml --set stops.0.cl\t", "stops.0.clearance_m="))
    terminal.clears_line()
    print("$ " + terminal.types("MANPAGER=cat MANWIDTH=100 man rubsweep | head -n 12\n", "DESCRIPTION").rstrip())


if __name__ == "__main__":
    main()
