"""Completion for zsh: one function for all programs."""

import re

from completed import ENDINGS

_ACTIONS = {"folder": "_files -/", "file": "_files", "key": " _rubsweep_keys", "setting": " _rubsweep_keys -S ="}
_KEYS = """\
_rubsweep_keys() {
  local program=rubsweep
  [[ $service != ringstab ]] || program=ringstab
  compadd "$@" -- ${(f)"$($program --keys 2>/dev/null | sed -n '/^[a-z]/{s/\\.N/.0/g;p}')"}
}
"""


def script(everything):
    """Text of the function's file."""
    names = " ".join(one.name for one in everything)
    cases = "".join(_pictures(one) if one.pictures else f"  {one.name})\n{_arguments(one.options, one.source, 4)}    ;;\n"
                    for one in everything)
    return f"#compdef {names}\n# Made of the --help of the programs.\n{_KEYS}case $service in\n{cases}esac\n"


def _pictures(one):
    lines = [f"  {one.name})", "    if (( CURRENT == 2 )); then", "      local -a pictures", "      pictures=("]
    lines += [f"        '{_quoted(name)}:{_quoted(one.summaries.get(name, name))}'" for name in one.pictures]
    lines += ["      )", "      _describe picture pictures", "      return", "    fi", "    local picture=$words[2]",
              "    shift words", "    (( CURRENT-- ))", "    case $picture in"]
    for name, options in one.pictures.items():
        lines += [f"      {name})", _arguments(options, one.source, 8).rstrip("\n"), "        ;;"]
    return "\n".join([*lines, "    esac", "    ;;\n"])


def _arguments(options, source, indent):
    blank = " " * indent
    specs = [_spec(word) for word in options] + [f"'*:{source}:{_source(source)}'"]
    return f"{blank}_arguments " + f" \\\n{blank}  ".join(specs) + "\n"


def _source(source):
    if source in ENDINGS:
        return f'_files -g "*.{ENDINGS[source]}"'
    return _ACTIONS[source]


def _spec(word):
    meaning = re.sub(r"([\[\]\\:])", r"\\\1", word.meaning)
    many = "*" if word.name == "set" else ""
    action = ""
    if word.kind == "word":
        action = f":{word.name}:({' '.join(word.words)})"
    elif word.kind:
        action = f":{word.kind}:{_ACTIONS.get(word.kind, ' ')}"
    return f"'{many}--{word.name}[{_quoted(meaning)}]{action}'"


def _quoted(text):
    return text.replace("'", "'\\''")
