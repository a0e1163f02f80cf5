"""Maps as figures."""

import csv
import io
import subprocess
from typing import TYPE_CHECKING, Any, Dict, List, Optional

import numpy as np
import xarray as xr

from .programs import find

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def motion_kinds() -> Dict[str, Dict[str, str]]:
    """The kinds of motion by name, with the label and colour that every figure of rubsweep uses."""
    table = subprocess.run([find("rubsweep"), "--motion-kinds"], check=True, capture_output=True, text=True).stdout
    return {row["name"]: row for row in csv.DictReader(io.StringIO(table))}


def plot(rub: xr.Dataset, ax: "Optional[Axes]" = None, **pcolormesh: Any) -> "Axes":
    """Draws the kinds of motion of a map in the colours of the other figures, with a legend of those that occur, and
    returns the axes. `pcolormesh`: options of the matplotlib function of that name."""
    from matplotlib import pyplot
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    ax = pyplot.figure(figsize=(8, 4.5), constrained_layout=True).gca() if ax is None else ax
    kinds = motion_kinds()
    present: List[str] = [name for name in kinds if (rub["kind"] == name).any()]
    second, first = rub["kind"].dims
    codes = np.full(rub["kind"].shape, np.nan)
    for code, name in enumerate(present):
        codes[rub["kind"].values == name] = code
    colours = ListedColormap([kinds[name]["colour"] for name in present])
    ax.pcolormesh(rub[first], rub[second], codes, cmap=colours, vmin=-0.5, vmax=len(present) - 0.5, shading="nearest",
                  **pcolormesh)
    ax.set_xlabel(axis_label(rub, str(first)))
    ax.set_ylabel(axis_label(rub, str(second)))
    handles = [Patch(facecolor=kinds[name]["colour"], edgecolor="#888888", label=kinds[name]["label"]) for name in present]
    ax.legend(handles=handles, loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False)
    return ax


def axis_label(rub: xr.Dataset, name: str) -> str:
    """`speed (Hz)` of speed_hz; `whirl ratio` of whirl_ratio."""
    unit = rub[name].attrs["units"]
    words = name.split("_")
    return " ".join(words) if unit == "1" else f"{' '.join(words[:-1]) or name} ({unit})"
