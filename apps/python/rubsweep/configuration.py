"""Configurations as the programs read them."""

import json
import os
from pathlib import Path
from typing import Any, List, Mapping, Union

Path_ = Union[str, "os.PathLike[str]"]
Configuration = Union[Path_, Mapping[str, Any]]


def path_of(configuration: Configuration, directory: str) -> str:
    """The file of a configuration. A dict is written into `directory`, one key per line, so that errors have line numbers.
    Relative paths in a dict start from the caller's current directory."""
    if not isinstance(configuration, Mapping):
        return os.fspath(configuration)
    path = Path(directory) / "configuration.yaml"
    whole = with_whole_paths(configuration)
    # The configuration of a map must name an output directory, although the call passes it as an argument.
    if "sweep" in whole:
        whole.setdefault("output", {"directory": "results"})
    path.write_text(json.dumps(whole, indent=2, default=plain) + "\n", encoding="utf-8")
    return str(path)


def with_whole_paths(value: Any, key: str = "") -> Any:
    """A copy in which relative paths of files are replaced by absolute ones."""
    if isinstance(value, Mapping):
        return {str(name): with_whole_paths(item, str(name)) for name, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [with_whole_paths(item) for item in value]
    return os.path.abspath(value) if key in ("file", "base") and isinstance(value, (str, os.PathLike)) else value


def plain(value: Any) -> Any:
    """A NumPy number or array, or a path, converted for JSON."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{value!r} cannot stand in a configuration")


def overridden(overrides: Mapping[str, Any]) -> List[str]:
    """The options that replace values: `sweep.speed_hz.count` by its path, or as a keyword with two underscores for each
    dot, `sweep__speed_hz__count=20`."""
    options = []
    for name, value in overrides.items():
        text = value if isinstance(value, str) else json.dumps(value, default=plain)
        options += ["--set", f"{name.replace('__', '.')}={text}"]
    return options
