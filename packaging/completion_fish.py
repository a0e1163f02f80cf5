"""Completion for fish: a file for each program."""

from completed import ENDINGS, asked_for_keys

_KEYS = "({program} --keys 2>/dev/null | string match -r \\'^[a-z].*\\' | string replace -a .N .0 | string replace -r \\'$\\' \\'{end}\\')"
_VALUES = {"folder": " -x -a '(__fish_complete_directories)'", "file": " -r -F", "text": " -x", "": ""}


def script(one):
    """Text of the file for this program."""
    lines = ["# Made of the --help of the program.", *_source(one)]
    for word in one.options:
        lines.append(_option(one.name, "", word))
    for picture, options in one.pictures.items():
        lines.append(f"complete -c {one.name} -n __fish_use_subcommand -f -a {picture} "
                     f"-d '{_quoted(one.summaries.get(picture, picture))}'")
        for word in options:
            lines.append(_option(one.name, f" -n '__fish_seen_subcommand_from {picture}'", word))
    return "\n".join(lines) + "\n"


def _source(one):
    if one.source in ENDINGS:
        ending = ENDINGS[one.source]
        return [f"complete -c {one.name} -f", f"complete -c {one.name} -k -a "
                f"'(__fish_complete_suffix .{ending} | string match -er \"(/|[.]{ending})\\$\")'"]
    if one.source == "folder":
        return [f"complete -c {one.name} -x -a '(__fish_complete_directories)'"]
    return []


def _option(name, condition, word):
    if word.kind in ("key", "setting"):
        keys = _KEYS.format(program=asked_for_keys(name), end="=" if word.kind == "setting" else "")
        return f"complete -c {name}{condition} -l {word.name} -x -a '{keys}' -d '{_quoted(word.meaning)}'"
    values = f" -x -a '{' '.join(word.words)}'" if word.kind == "word" else _VALUES[word.kind]
    return f"complete -c {name}{condition} -l {word.name}{values} -d '{_quoted(word.meaning)}'"


def _quoted(text):
    return text.replace("\\", "\\\\").replace("'", "\\'")
