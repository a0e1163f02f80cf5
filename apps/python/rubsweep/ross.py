"""Rotors of ROSS, the open source rotordynamics library."""

import os
from pathlib import Path
from typing import Any, Dict, Optional

from .configuration import Path_


def from_ross(rotor: Any, file: Optional[Path_] = None) -> Dict[str, Any]:
    """The part `rotor` of a configuration of a rotor of ROSS.

    rotor: a ross.Rotor, or the path of a file that `rotor.save` wrote.
    file: where to write a ross.Rotor, as TOML; rotor.toml in the current directory unless given. The configuration names
        it, and it must stay as long as that is used.

    Unbalance, damping and what else the file has no place for are keys to be added; the program names those that it
    lacks: `{**rubsweep.from_ross(rotor), "unbalance": [{"disc": "Disk 0", ...}]}`.
    """
    if isinstance(rotor, (str, os.PathLike)):
        path = Path(rotor)
    else:
        path = Path(file if file is not None else "rotor.toml")
        rotor.save(path)
    return {"kind": "ross", "file": str(path.resolve())}
