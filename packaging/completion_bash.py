"""Completion for bash: one file for all programs, loaded under the name of each."""

from completed import ENDINGS

_HEAD = """\
# Completion of the programs of rubsweep in bash; made of their --help.
_rubsweep_keys() {
  local program=rubsweep end=''
  [[ $1 != ringstab ]] || program=ringstab
  [[ $2 == key ]] || end='='
  "$program" --keys 2>/dev/null | sed -n "/^[a-z]/{s/\\.N/.0/g;s/$/$end/p}"
}

_rubsweep() {
  local word=$2 before=$3 options values source kind
  case ${1##*/} in
"""

_TAIL = """\
  esac
  kind=''
  [[ $before == --* && " $values " == *" $before:"* ]] && kind=${values##*"$before:"} && kind=${kind%% *}
  case $kind in
    '') ;;
    text) return ;;
    folder) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$word"); return ;;
    key | setting)
      [[ $kind == key ]] || compopt -o nospace
      mapfile -t COMPREPLY < <(compgen -W "$(_rubsweep_keys "${1##*/}" "$kind")" -- "$word")
      return ;;
    file) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- "$word"); return ;;
    *) mapfile -t COMPREPLY < <(compgen -W "${kind//,/ }" -- "$word"); return ;;
  esac
  if [[ $word == -* || $source == picture ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
    return
  fi
  compopt -o filenames
  mapfile -t COMPREPLY < <(
    compgen -d -- "$word"
    case $source in
      folder) ;;
      file) compgen -f -- "$word" | while IFS= read -r one; do [[ -d $one ]] || printf '%s\\n' "$one"; done ;;
      *) compgen -f -X "!*.$source" -- "$word" ;;
    esac)
}
"""


def script(everything):
    """Text of the file for these programs."""
    cases = "".join(_case(one) for one in everything)
    names = " ".join(one.name for one in everything)
    return f"{_HEAD}{cases}{_TAIL}complete -F _rubsweep {names}\n"


def _case(one):
    source = ENDINGS.get(one.source, one.source)
    if not one.pictures:
        return f"    {one.name})\n{_settings(one.options, source, 6)}      ;;\n"
    names = " ".join(one.pictures)
    lines = [f"    {one.name})", "      case ${COMP_CWORD}:${COMP_WORDS[1]} in",
             f"        1:*) options='{names} {_names(one.options)}' values='' source=picture ;;"]
    for picture, options in one.pictures.items():
        lines += [f"        *:{picture})", _settings(options, source, 10).rstrip("\n"), "          ;;"]
    return "\n".join([*lines, "        *) options='' values='' source=file ;;", "      esac", "      ;;\n"])


def _settings(options, source, indent):
    values = " ".join(f"--{word.name}:{','.join(word.words) or word.kind}" for word in options if word.kind)
    blank = " " * indent
    return f"{blank}options='{_names(options)}'\n{blank}values='{values}'\n{blank}source={source}\n"


def _names(options):
    return " ".join("--" + word.name for word in options)
