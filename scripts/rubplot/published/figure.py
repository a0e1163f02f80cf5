"""The subcommand that computes and draws published figures, all that stand in results/figures."""

import difflib

from rubplot import output
from rubplot.failure import WrongCall
from rubplot.published import maps, motions, rings, rotor_kit
from rubplot.published.sources import Sources, Wanted
from rubplot.subcommand import Subcommand

FIGURES = {**motions.FIGURES, **maps.FIGURES, **rotor_kit.FIGURES, **rings.FIGURES}
GROUPS = {
    "all": sorted({*motions.FIGURES, *maps.FIGURES} - {*maps.BENCHMARKS},
                  key=lambda name: (not name.startswith("figure"), name)),
    "benchmarks": maps.BENCHMARKS,
    "ring": list(rings.FIGURES),
}


def find(word):
    """The names that a word stands for; a number is that of a figure. Raises WrongCall."""
    name = word.replace("-", "_")
    if name.startswith("ring_") and name[len("ring_"):].isdecimal():
        name = f"ring_figure{name[len('ring_'):]}"
    if name.isdecimal():
        name = f"figure{int(name):02}"
    if name in GROUPS:
        return GROUPS[name]
    if name in FIGURES:
        return [name]
    close = difflib.get_close_matches(name, [*FIGURES, *GROUPS], n=1, cutoff=0.8)
    raise WrongCall(f"there is no figure '{word}', " + (f"did you mean {close[0]}?" if close else
                                                        f"allowed: {', '.join([*GROUPS, *FIGURES])}"))


def run(given):
    names = [name for word in given.names for name in find(word)]
    formats = None if given.formats is None else output.read_formats(given.formats)
    if len(names) > 1 and (given.output or given.map):
        raise WrongCall("--output and --map belong to a single figure")
    if given.map and names[0] not in {**maps.FIGURES, **rotor_kit.FIGURES}:
        raise WrongCall(f"--map: {names[0]} shows no map, allowed: {', '.join({**maps.FIGURES, **rotor_kit.FIGURES})}")
    standard = Sources()
    sources = Sources(given.configs or standard.configs, given.programs or standard.programs,
                      given.results or standard.results)
    for name in names:
        if len(names) > 1:
            print(name.replace("_", " "), flush=True)
        FIGURES[name].draw(name, sources, Wanted(given.output, formats, given.map))


def options(parser):
    parser.add_argument("names", metavar="FIGURE", nargs="+", help="a number, a name as above, or all, benchmarks, ring")
    parser.add_argument("--map", metavar="PATH", help="a map.csv that is there already; of rotor_kit, the directory of its data")
    parser.add_argument("-o", "--output", metavar="FILE", help="of one figure (default: results/figures/NAME)")
    parser.add_argument("--formats", metavar="LIST", help=f"some of {','.join(output.FORMATS)} (default: png,svg, ring: png)")
    parser.add_argument("--programs", metavar="DIR", help="where rubsweep and its sisters are (default: build/release/apps)")
    parser.add_argument("--configs", metavar="DIR", help="where their configurations are (default: configs)")
    parser.add_argument("--results", metavar="DIR", help="where maps and figures go (default: results)")


SUBCOMMAND = Subcommand(
    name="figure",
    summary="published figures, computed first where they are not there",
    description="""Computes and draws published figures: figure04 to figure13, both_sides_unequal and figure19 (15 to 21) of the
reference machine, rotor_kit, ring_figure03 to ring_figure21; and the maps of the benchmarks, set_a_one_side and others.""",
    source="FIGURE",
    run=run,
    options=options,
    examples=("06", "07 10 13", "all", "06 --map results/mine/map.csv --output mine.pdf", "ring-10 benchmarks"),
)
