"""Maps as xarray Datasets."""

from itertools import combinations
from pathlib import Path
from typing import Any, List, Optional, Tuple

import numpy as np
import pandas as pd
import xarray as xr

from .configuration import Configuration, Path_
from .results import execute, place
from .tables import read_table, unit_of


# Words in the order of their codes; unknown words of a newer program are appended.
CLASSES = ("non_contact", "synchronous", "subharmonic", "quasi_periodic", "chaotic", "resting_contact", "unsettled", "initial_contact",
           "failed")


def run(configuration: Configuration, *, output: Optional[Path_] = None, threads: int = 0, progress: Optional[bool] = None,
        **overrides: Any) -> xr.Dataset:
    """Computes a map, and returns it as `read_map` does.

    configuration: path of a YAML file, or a dict of the same keys (`rubsweep --keys` lists them).
    output: directory to keep; a call with the same one goes on where an earlier one was interrupted. Unless given the
        files are gone afterwards.
    threads: 0 for one per processor; results do not depend on it.
    overrides: values to replace, by path: `**{"rotor.damping_ratio": 0.03}` or `rotor__damping_ratio=0.03`.

    Throws BadInput (configuration), RubsweepError (anything else), KeyboardInterrupt. A cell that failed is a cell whose
    `status` is not `ok`.
    """
    with place(output) as directory:
        execute("rubsweep", configuration, ["--threads", str(threads)], overrides, directory, progress)
        return read_map(directory)


def cells(path: Path_) -> pd.DataFrame:
    """The rows of a map, one per cell, of a map.csv or of the directory that holds it."""
    path = Path(path)
    return read_table(path / "map.csv" if path.is_dir() else path)


def read_map(path: Path_) -> xr.Dataset:
    """A map that `rubsweep` or `rubbasin` wrote, by its two axes.

    Dimensions are (second axis, first axis), as (whirl_ratio, speed_hz), which is how a figure has them. Every column is
    a variable of that shape with attribute `units`; words are strings, empty where a cell has none. `class_code` is the
    class as a categorical: int8 with the attributes flag_values and flag_meanings of the CF conventions, the same for all
    maps. Cells of a map that is no grid, as a refined one, are laid on the grid of all values, with NaN between
    them. Throws ValueError for a table that has no two axes.
    """
    table = cells(path)
    first, second = axes_of(table)
    x, y = np.unique(table[first]), np.unique(table[second])
    place_of = np.searchsorted(y, table[second]) * len(x) + np.searchsorted(x, table[first])
    dataset = xr.Dataset(coords={first: ([first], x, {"units": unit_of(first)}),
                                 second: ([second], y, {"units": unit_of(second)})},
                         attrs={"head": "\n".join(table.attrs["head"])})
    for column in table.columns.difference([first, second], sort=False):
        values, attributes = variable_of(table[column])
        whole = np.full(len(x) * len(y), "" if values.dtype == object else np.nan, dtype=values.dtype)
        whole[place_of] = values
        dataset[column] = ((second, first), whole.reshape(len(y), len(x)), attributes)
        if column == "class":
            dataset["class_code"] = ((second, first), *codes_of(dataset[column].values))
    return dataset


def axes_of(table: pd.DataFrame) -> Tuple[str, str]:
    """The two columns whose pair of values identifies every cell; columns that form a grid are preferred."""
    limit = list(table.columns).index("class") if "class" in table.columns else len(table.columns)
    candidates: List[str] = [column for column in table.columns[:limit] if pd.api.types.is_numeric_dtype(table[column])]
    pairs = [pair for pair in combinations(candidates, 2) if not table.duplicated(subset=list(pair)).any()]
    if not pairs:
        raise ValueError(f"no two of the columns {', '.join(candidates)} tell all cells apart; read them with cells()")
    return min(pairs, key=lambda pair: int(table[pair[0]].nunique() * table[pair[1]].nunique()))


def variable_of(column: "pd.Series[Any]") -> "Tuple[np.ndarray[Any, Any], dict[str, str]]":
    if pd.api.types.is_numeric_dtype(column):
        return column.to_numpy(dtype=float), {"units": unit_of(str(column.name))}
    return column.astype(object).fillna("").to_numpy(), {}


def codes_of(words: "np.ndarray[Any, Any]") -> "Tuple[np.ndarray[Any, Any], dict[str, Any]]":
    meanings = [*CLASSES, *sorted(set(words.ravel()) - {"", *CLASSES})]
    codes = pd.Categorical(words.ravel(), categories=meanings).codes.astype(np.int8).reshape(words.shape)
    return codes, {"flag_values": np.arange(len(meanings), dtype=np.int8), "flag_meanings": " ".join(meanings)}
