"""How a program of this folder starts and ends: exit code 1 for a wrong command line, 3 for a file that cannot be used."""

import os
import sys

from rubplot.configuration import ConfigurationError
from rubplot.csv_table import TableError
from rubplot.failure import Failure


def run_program(main, usage, least=0, most=None):
    """Calls `main` with the arguments of the command line, of which there are `least` to `most` (None: any number).

    A failure is said in one line on stderr that begins with the name of the program as its usage has it.
    """
    name = usage.split()[0]
    arguments = sys.argv[1:]
    if len(arguments) < least or (most is not None and len(arguments) > most):
        sys.exit(_say(1, f"{name}: usage: {usage}"))
    try:
        main(arguments)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # whoever read it has had enough
    except OSError as error:
        sys.exit(_say(3, f"{name}: cannot use {error.filename}: {error.strerror}"))
    except (Failure, TableError, ConfigurationError) as error:
        sys.exit(_say(3, f"{name}: {error}"))


def _say(code, message):
    print(message, file=sys.stderr)
    return code
