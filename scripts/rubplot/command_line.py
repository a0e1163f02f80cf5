"""The command line of rubplot: its subcommands, its help, and what a wrong call is told.

Exit codes: 0 done, 2 a wrong call, 3 a file or a program that cannot be used, 130 interrupted.
"""

import argparse
import difflib
import sys
import textwrap

from rubplot import VERSION, output, subcommand
from rubplot.configuration import ConfigurationError
from rubplot.csv_table import TableError
from rubplot.failure import Failure, WrongCall
from rubplot.subcommands import ALL

DONE, WRONG_CALL, CANNOT_USE, INTERRUPTED = 0, 2, 3, 130
WIDTH = 100  # of the help, in letters


def main(arguments):
    """Draws what the arguments say; returns the exit code."""
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(encoding="utf-8", errors="backslashreplace")
    one = None
    try:
        if arguments[:1] in (["-h"], ["--help"]):
            print(overview())
            return DONE
        if arguments[:1] == ["--version"]:
            print(f"rubplot {VERSION}")
            return DONE
        one = _named(arguments)
        given = parser_of(one).parse_args(arguments[1:])
        (one.run or (lambda read: subcommand.draw(one, read)))(given)
    except WrongCall as error:
        return _say(WRONG_CALL, f"{error}\nTry: rubplot {one.name + ' ' if one else ''}--help")
    except OSError as error:
        return _say(CANNOT_USE, f"cannot use {error.filename}: {error.strerror}")
    except (Failure, TableError, ConfigurationError) as error:
        return _say(CANNOT_USE, str(error))
    except KeyboardInterrupt:
        return _say(INTERRUPTED, "interrupted; nothing was drawn")
    except Exception as error:  # damage that no check foresaw: a file is named, and no traceback shown
        return _say(CANNOT_USE, f"{_sources(given)}: not as a program writes it ({type(error).__name__}: {error})")
    return DONE


def _sources(given):
    source = getattr(given, "source", None) or getattr(given, "names", "")
    return source if isinstance(source, str) else ", ".join(source)


def overview():
    """The help without a subcommand."""
    listed = "\n".join(f"  {one.name:<16}{one.summary}" for one in ALL)
    return f"""\
usage: rubplot PICTURE SOURCE... [OPTION]...

Draws what the programs of rubsweep wrote, by gnuplot, as PNG, SVG and PDF.

pictures:
{listed}

`rubplot PICTURE --help` says more of each.

`rubplot --version` says the version.

examples:
  rubplot map results/benchmark/one_side
  rubplot line results/my_line --output bifurcation.pdf
  rubplot trace results/my_trace --heading 'A rub' --formats svg,pdf

exit codes: 0 done, 2 a wrong call, 3 a file or a program that cannot be used, 130 interrupted"""


def parser_of(one):
    """Reads the arguments behind the name of a subcommand."""
    examples = "\n".join(f"  rubplot {one.name} {text}" for text in one.examples)
    parser = _Parser(prog=f"rubplot {one.name}", description=textwrap.fill(one.description, WIDTH), epilog=f"examples:\n{examples}")
    if one.picture:
        parser.add_argument("source", metavar=one.source, nargs="+" if one.several_sources else None)
        parser.add_argument("-o", "--output", metavar="FILE", help="what ends with .png, .svg or .pdf is that file; "
                            f"behind another name stand the endings of --formats (default: {one.name}, beside the source)")
        parser.add_argument("--formats", metavar="LIST", help=f"some of {','.join(output.FORMATS)} "
                            f"(default: {','.join(output.DEFAULT_FORMATS)})")
        parser.add_argument("--heading", metavar="TEXT", default=one.heading,
                            help="(default: '%(default)s')" if one.heading else "(default: what the picture shows)")
    subcommand.add_units(one, parser)
    one.options(parser)
    return parser


class _Parser(argparse.ArgumentParser):
    """Takes whole names of options alone, and says which one might be meant."""

    def __init__(self, **settings):
        super().__init__(
            allow_abbrev=False,
            formatter_class=lambda prog: argparse.RawDescriptionHelpFormatter(prog, max_help_position=28, width=WIDTH),
            **settings,
        )

    def error(self, message):
        raise WrongCall(message)

    def parse_args(self, args=None, namespace=None):
        for word in args[: args.index("--")] if "--" in args else args:
            name = word.split("=")[0]
            if name.startswith("--") and name not in self._option_string_actions:
                raise WrongCall(f"there is no option {name}{_meant(name, list(self._option_string_actions))}")
        return super().parse_intermixed_args(args, namespace)


def _named(arguments):
    """The subcommand that the first argument names."""
    names = [one.name for one in ALL]
    if not arguments:
        raise WrongCall(f"a picture is needed, allowed: {', '.join(names)}")
    for one in ALL:
        if one.name == arguments[0]:
            return one
    raise WrongCall(f"'{arguments[0]}' is no picture{_meant(arguments[0], names)}")


def _meant(word, names):
    close = difflib.get_close_matches(word, names, n=1, cutoff=0.6)
    return f", did you mean {close[0]}?" if close else f", allowed: {', '.join(names)}"


def _say(code, message):
    print(f"rubplot: {message}", file=sys.stderr)
    return code
