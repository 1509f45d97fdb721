"""Files of force records as named channels: CSV, HDF5, MATLAB, TDMS."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from haptonic.errors import FrictionError, nearest
from haptonic.foreign.process import ForeignError, ask
from haptonic.vibrometry.findings import Notebook
from haptonic.vibrometry.readers.matlab import matlab_arrays
from haptonic.vibrometry.readers.tdms import Channel, Content, number_of, samples_of, tdms_content

Array = NDArray[np.float64]

FORMATS = (".csv", ".h5", ".hdf5", ".mat", ".tdms")
SIMULATED = "simulated"
RATES = ("sample_rate", "sampling_rate", "fs", "rate")  # Hz: an attribute, or a variable with one number
_UNIT = re.compile(r"^(?P<name>.*?)\s*[\[(](?P<unit>[^\])]*)[\])]\s*$")


@dataclass(frozen=True, eq=False)
class Channels:
    """Channels of a file, or of a group in it. A channel is read when it is asked for, and then kept.

    readers : name -> what reads it, without the unit that a name such as "Fz (mN)" ends with
    units : name -> unit, where the file says one
    rate : sampling rate, Hz, if the file says it
    simulated : whether the file says that it is
    """

    readers: Mapping[str, Callable[[], object]]
    units: Mapping[str, str] = field(default_factory=dict)
    rate: float | None = None
    simulated: bool = False
    _kept: dict[str, Array] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Array:
        """(samples,) one channel, in the unit of the file.

        Raises
        ------
        FrictionError : no such channel, or it holds text
        """
        if name not in self.readers:
            guess = nearest(name, self.readers)
            raise FrictionError(
                argument=f"channel {name}",
                given=", ".join(self.readers) or "no channel of numbers",
                allowed="a file with this channel",
                cause="the column has another name, or the file is another one",
                next_step=f'did you mean "{guess}"? Say so in [trials.sensor]'
                if guess
                else "name the channels in [trials.sensor]",
            )
        if name not in self._kept:
            try:
                self._kept[name] = np.asarray(self.readers[name](), dtype=float).ravel()
            except (TypeError, ValueError):
                raise FrictionError(
                    argument=f"channel {name}",
                    given="text among the numbers",
                    allowed="numbers",
                    cause="a line of text within the data, or decimal commas",
                    next_step="look at the file in a text editor",
                ) from None
        return self._kept[name]


@contextmanager
def opened(path: Path) -> Iterator[Callable[[str], Channels]]:
    """Open a file once; what it yields gives the channels of a group, "" for those of the file itself.

    Raises
    ------
    FrictionError : there is no such file, it is damaged or of another format; on asking, no such group
    ScanError : a damaged MATLAB or TDMS file, or no npTDMS
    """
    kind = path.suffix.lower()
    try:
        if not path.is_file():  # a name that is too long for any file raises an error
            raise _unreadable(path, "no such file", "check its name in the table of trials")
        if kind == ".csv":
            table = _table(path)
            yield lambda group: _of_columns(path, table, group)
        elif kind in (".h5", ".hdf5"):
            content = ask("hdf5.tree", path)
            yield lambda group: _of_hdf5(path, content, group)
        elif kind == ".mat":
            arrays = matlab_arrays(path, Notebook(path, "MATLAB"))
            yield lambda group: _of_arrays(path, arrays, group)
        elif kind == ".tdms":
            whole = tdms_content(path)
            yield lambda group: _of_tdms(path, whole, group)
        else:
            raise _unreadable(path, f'"{kind}" is no ending of a format that is read', "save it as CSV")
    except MemoryError as error:
        raise _unreadable(path, "it does not fit into memory, or is damaged", "divide it") from error
    except (
        ForeignError,
        OSError,
        UnicodeDecodeError,
        pd.errors.ParserError,
        pd.errors.EmptyDataError,
    ) as error:
        found = error if isinstance(error, ForeignError) else type(error).__name__
        cause = f"it is damaged, or of another kind than its name says ({found})"
        raise _unreadable(path, cause, "open it in another program to see") from error


def _table(path: Path) -> tuple[pd.DataFrame, bool]:
    """A CSV file, and whether its comments say that it is simulated."""
    with path.open(encoding="utf-8-sig") as file:
        head = [line for _, line in zip(range(20), file, strict=False)]
    plain = next((line for line in head if line.strip() and not line.startswith("#")), "")
    comments = " ".join(line.lower() for line in head if line.startswith("#"))
    # a table from a program with decimal commas separates its columns by semicolons
    form = {"sep": ";", "decimal": ","} if ";" in plain else {}
    table = pd.read_csv(path, comment="#", skipinitialspace=True, encoding="utf-8-sig", **form)
    return table, SIMULATED in comments


def _of_columns(path: Path, table: tuple[pd.DataFrame, bool], group: str) -> Channels:
    if group:
        raise _no_group(path, group, [])
    data, simulated = table
    simulated |= "origin" in data and SIMULATED in set(data["origin"].head(1))
    plain = {str(name): name for name in data.columns}
    named = {name: _UNIT.match(name) for name in plain}
    readers = {
        (found["name"] if found else name): partial(data[plain[name]].to_numpy)
        for name, found in named.items()
    }
    units = {found["name"]: found["unit"].strip() for found in named.values() if found}
    return Channels(readers, units, simulated=simulated)


def _of_hdf5(path: Path, content: Mapping[str, Any], group: str) -> Channels:
    groups = [name for name in content["groups"] if "/" not in name]
    if group and group not in content["groups"]:
        raise _no_group(path, group, groups)
    start = f"{group}/" if group else ""
    sets = {
        name.removeprefix(start): form
        for name, form in content["sets"].items()
        if name.startswith(start) and "/" not in name.removeprefix(start)
        if len(form["shape"]) == 1 and form["kind"] == "number"
    }
    if not sets and groups and not group:
        raise _no_group(path, "", groups)
    units = {name: form["attributes"].get("units") for name, form in sets.items()}
    attributes = content["attributes"] | content["groups"].get(group, {})
    return Channels(
        {name: partial(_of_set, path, start + name) for name in sets},
        {name: unit for name, unit in units.items() if isinstance(unit, str)},
        _rate(attributes),
        attributes.get("origin") == SIMULATED,
    )


def _of_set(path: Path, name: str) -> NDArray[Any]:
    (values,) = ask("hdf5.read", path, names=[name])
    return np.asarray(values)


def _of_arrays(path: Path, arrays: Mapping[str, NDArray[Any]], group: str) -> Channels:
    """Variables of a MATLAB file; a group is a structure."""
    start = f"{group}." if group else ""
    inside = {name.removeprefix(start): array for name, array in arrays.items() if name.startswith(start)}
    if not inside:
        raise _no_group(path, group, sorted({name.partition(".")[0] for name in arrays if "." in name}))
    lines = {name: array for name, array in inside.items() if array.size == max(array.shape, default=0) > 1}
    numbers = {name: array.ravel()[0] for name, array in inside.items() if array.size == 1}
    simulated = bool(numbers.get("simulated", False))
    return Channels(
        {name: partial(np.asarray, array) for name, array in lines.items()}, {}, _rate(numbers), simulated
    )


def _of_tdms(path: Path, file: Content, group: str) -> Channels:
    groups = {one.name: one for one in file.groups}
    if not group and len(groups) == 1:
        group = next(iter(groups))
    if group not in groups:
        raise _no_group(path, group, list(groups))
    channels = {channel.name: channel for channel in groups[group].channels if channel.numbers}
    rates = [channel.timing[1] for channel in channels.values()]
    properties = {**file.properties, **groups[group].properties}
    return Channels(
        {name: partial(_samples, path, channel) for name, channel in channels.items()},
        {
            name: str(channel.properties["unit_string"])
            for name, channel in channels.items()
            if channel.properties.get("unit_string")
        },
        rates[0] if rates and rates[0] > 0 else None,
        properties.get("origin", "") == SIMULATED,
    )


def _samples(path: Path, channel: Channel) -> NDArray[Any]:
    return samples_of(path, [channel])[0]


def _rate(attributes: Mapping[str, Any]) -> float | None:
    rates = (number_of(attributes[name]) for name in RATES if name in attributes)
    return next((rate for rate in rates if np.isfinite(rate) and rate > 0), None)


def _unreadable(path: Path, given: str, next_step: str) -> FrictionError:
    return FrictionError(
        argument=path.name,
        given=given,
        allowed=f"a readable file that ends in {', '.join(FORMATS)}",
        cause="the file was moved, renamed, cut or saved in another format",
        next_step=next_step,
    )


def _no_group(path: Path, group: str, groups: list[str]) -> FrictionError:
    return FrictionError(
        argument=f"group in {path.name}",
        given=f'"{group}"' if group else "none",
        allowed=f"one of {', '.join(groups[:10])}" if groups else "no group: the file has none",
        cause="the column group of the table of trials is missing, or a name in it is misspelt",
        next_step="put the column group right",
    )
