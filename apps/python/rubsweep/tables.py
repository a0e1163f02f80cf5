"""Tables that the programs write, with the unit of each column."""

import os
from typing import List, Union

import pandas as pd

UNITS = {"hz": "Hz", "m": "m", "mm": "mm", "um": "um", "mil": "mil", "s": "s", "n": "N", "ns": "N s", "nm": "N m", "kg": "kg",
         "g": "g", "deg": "deg", "rad": "rad", "j": "J", "w": "W", "v": "V", "mv": "mV", "rpm": "1/min", "m2": "m^2", "m3": "m^3",
         "revolution": "revolution", "revolutions": "revolution", "turns": "revolution", "percent": "%"}
WORDS = ("class", "kind", "order", "orbit", "whirl", "proof", "robust", "status", "start", "stability", "label", "attractor", "pass",
         "end", "candidate", "verdict", "event")


def unit_of(column: str) -> str:
    """The unit that the name of a column ends with: `m/s` of `vx_m_per_s`; `1` where it names none."""
    parts = column.split("_")
    for first in range(0 if len(parts) == 1 else 1, len(parts)):
        unit = unit_from(parts[first:])
        if unit:
            return unit
    return "1"


def unit_from(parts: List[str]) -> str:
    """`kg_m2_per_s` as `kg m^2/s`; empty where a part is not a unit."""
    above = parts[:parts.index("per")] if "per" in parts else parts
    below = parts[len(above) + 1:]
    if any(part not in UNITS for part in above + below) or not above + below or ("per" in parts and not below):
        return ""
    over = " ".join(UNITS[part] for part in above) or "1"
    under = " ".join(UNITS[part] for part in below)
    return f"{over}/({under})" if len(below) > 1 else f"{over}/{under}" if below else over


def read_table(path: Union[str, "os.PathLike[str]"]) -> pd.DataFrame:
    """A table of any of the programs; `attrs["units"]` has the unit of each column of numbers, `attrs["head"]` what the
    lines before the header say. Columns of repeated words are categorical."""
    head = []
    with open(path, encoding="utf-8") as file:
        for text in file:
            if not text.startswith("#"):
                break
            head.append(text[1:].strip())
    table = pd.read_csv(path, skiprows=len(head), float_precision="round_trip")
    for column in table.columns:
        if column in WORDS and table[column].dtype == object:
            table[column] = table[column].astype("category")
    table.attrs["head"] = head
    table.attrs["units"] = {column: unit_of(str(column)) for column in table.columns
                            if pd.api.types.is_numeric_dtype(table[column])}
    return table
