"""Tables and text from one call of a program."""

import tempfile
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Dict, Iterator, Mapping, Optional, Sequence

import pandas as pd

from .configuration import Configuration, Path_, overridden, path_of
from .programs import Answer, call
from .tables import read_table


class Results(Mapping[str, pd.DataFrame]):
    """Tables by the names of their files without the ending: `results["section"]`. `text` is what the program printed,
    `summary` its summary; `directory` is None where the files were not kept."""

    def __init__(self, tables: Dict[str, pd.DataFrame], answer: Answer, directory: Optional[Path]) -> None:
        self._tables = tables
        self.text = answer.text
        self.summary = answer.summary
        self.directory = directory

    def __getitem__(self, name: str) -> pd.DataFrame:
        return self._tables[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._tables)

    def __len__(self) -> int:
        return len(self._tables)

    def __repr__(self) -> str:
        return f"Results({', '.join(f'{name}: {len(table)} rows' for name, table in self._tables.items())})"


@contextmanager
def place(output: Optional[Path_]) -> Iterator[Path]:
    """The directory of the output, or a temporary one that is removed at the end."""
    if output is not None:
        yield Path(output)
        return
    with tempfile.TemporaryDirectory(prefix="rubsweep-") as directory:
        yield Path(directory) / "output"


def execute(program: str, configuration: Configuration, options: Sequence[str], overrides: Mapping[str, Any],
            output: Path, progress: Optional[bool]) -> Answer:
    """Runs a program on a configuration with overridden values, into `output`."""
    with tempfile.TemporaryDirectory(prefix="rubsweep-") as directory:
        arguments = [path_of(configuration, directory), *options, *overridden(overrides), "--output", str(output)]
        return call(program, arguments, progress)


def collect(program: str, configuration: Configuration, options: Sequence[str], overrides: Mapping[str, Any],
            output: Optional[Path_], progress: Optional[bool]) -> Results:
    """Runs a program, and reads every table that it wrote."""
    with place(output) as directory:
        return read_all(execute(program, configuration, options, overrides, directory, progress), output)


def read_all(answer: Answer, output: Optional[Path_]) -> Results:
    """Every table that a program wrote; `output` is None where its directory is temporary."""
    written = [Path(file) for file in answer.summary.get("files", []) if file.endswith(".csv")]
    return Results({file.stem: read_table(file) for file in written}, answer, None if output is None else Path(output))
