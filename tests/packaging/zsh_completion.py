"""zsh_completion.py FOLDER: for each line of standard input what zsh offers behind it with the functions in FOLDER, a
candidate per line, and an empty line.

zsh completes in its line editor alone, which needs a terminal: it gets a pseudo terminal, and candidates are taken where
they are handed over, at compadd.
"""

import os
import pty
import re
import select
import sys
import tempfile
import time

_SETUP = r"""
PS1= ; PROMPT_EOL_MARK= ; unsetopt zle_bracketed_paste prompt_sp
fpath=(FOLDER $fpath)
autoload -Uz compinit && compinit -D -u
compadd() {
  if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then builtin compadd "$@"; return; fi
  typeset -a __hits; local __prefix= __suffix=
  builtin compadd -A __hits "$@"
  local i; for ((i = 1; i < $#; i++)); do { [[ ${@[i]} == -p ]] && __prefix=${@[i+1]}; [[ ${@[i]} == -S ]] && __suffix=${@[i+1]} }; done
  [[ ${@[(r)-f]} == -f ]] && for ((i = 1; i <= $#__hits; i++)); do [[ -d $__prefix$__hits[i] ]] && __hits[i]+=/; done
  for i in $__hits; do print -r -- "<<$__prefix$i$__suffix>>"; done
  builtin compadd "$@"
}
offer() { compstate[insert]= ; compstate[list]= ; _main_complete ; compstate[insert]= ; compstate[list]= ; print "<<<end>>>" }
zle -C offer list-choices offer
bindkey '^X^A' offer
print '<<<ready''>>>'
"""


def candidates(folder, lines):
    """Yields the candidates of each line."""
    child, terminal = pty.fork()
    if child == 0:
        os.execvp("zsh", ["zsh", "-f", "-i"])
    try:
        with tempfile.NamedTemporaryFile("w", encoding="utf-8") as setup:
            setup.write(_SETUP.replace("FOLDER", folder))
            setup.flush()
            os.write(terminal, f"stty -echo cols 1000; source {setup.name}\n".encode())
            _until(terminal, "<<<ready>>>")
        for line in lines:
            os.write(terminal, line.rstrip("\n").encode() + b"\x18\x01")
            text = _until(terminal, "<<<end>>>")
            os.write(terminal, b"\x15")  # takes the line away
            yield sorted(set(re.findall(r"(?<!<)<<([^<>]+)>>(?!>)", text)))
    finally:
        os.close(terminal)
        os.waitpid(child, 0)


def _until(terminal, end, seconds=30):
    text = ""
    last = time.monotonic() + seconds
    while end not in text:
        ready, _, _ = select.select([terminal], [], [], max(0.0, last - time.monotonic()))
        if not ready:
            raise TimeoutError(f"zsh did not say {end}: {text}")
        text += os.read(terminal, 65536).decode("utf-8", "replace")
    return text


if __name__ == "__main__":
    for found in candidates(sys.argv[1], sys.stdin):
        print("\n".join([*found, ""]), flush=True)
