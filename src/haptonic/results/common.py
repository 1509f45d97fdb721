"""What every result has: the question it answers, a key in the store, a stamp, and files that are whole."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from importlib.metadata import version
from pathlib import Path, PurePosixPath
from typing import Any

from haptonic import hdf5
from haptonic.bloch.reach import rounded_up
from haptonic.bloch.settings import COARSEST
from haptonic.gate import passed
from haptonic.later import xarray as xr
from haptonic.names import variable
from haptonic.paths import inside
from haptonic.store import draft_for, fingerprint, refuse_overwrite, write_atomically
from haptonic.units import duration

Writer = Callable[[Path], object]


REASONS = {"time": "lack of time", "memory": "lack of memory", "range": "range of validity"}


def accuracy_remarks(attributes: Mapping[str, Any]) -> list[str]:
    """A warning where an accuracy was not reached: what was, why, and what to do.

    attributes : of a dataset; see `haptonic.bloch.model.BestModel.attributes`
    """
    asked, largest = attributes.get("accuracy"), attributes.get("largest_error")
    if asked is None or largest is None or largest <= asked:
        return []
    reached = f"{rounded_up(largest):g}"
    remark = (
        f"The accuracy asked for, {asked:g}, is not reached: errors go up to {reached} of a frequency"
        f"{', which tells little of gaps' if largest > COARSEST else ''}."
    )
    if "stopped_by" in attributes:
        remark += f" The reason is {REASONS[attributes['stopped_by']]}: {attributes['stopped_why']}."
    if "budget_needed_s" in attributes:
        remark += f' Ask again with --budget "{duration(attributes["budget_needed_s"])}" for the next mesh.'
    return [f"{remark} With accuracy = {reached} in [bands] no more than this is asked for."]


def write_files(folder: Path, writers: Mapping[Any, Writer], *, overwrite: bool) -> list[Path]:
    """Write files into a folder, each whole or not at all, and none if one may not be written.

    Names are texts, or paths of files below the folder; see `haptonic.paths.inside`.
    """
    refuse_taken(folder, writers, overwrite=overwrite)
    paths = [inside(folder, name) for name in writers]
    for path, writer in zip(paths, writers.values(), strict=True):
        write_atomically(path, writer)
    return paths


def refuse_taken(folder: Path | None, names: Iterable[str | PurePosixPath], *, overwrite: bool) -> None:
    """Raise ResourceError if one of the names is taken in a folder or leads out of it, or if nothing can be
    written there.

    Asked before the work starts, so that no run is lost on its last step. A folder that was not there is not
    left behind: what comes next may be refused.
    """
    if folder is None:
        return
    for name in names:
        refuse_overwrite(inside(folder, name), overwrite)
    with draft_for(folder) as (draft, rest):
        write_atomically(draft / rest / "probe", Path.touch)


def write_netcdf(dataset: xr.Dataset, path: Path) -> None:
    """NetCDF 4 by h5netcdf; names of variables may hold those of regions, see `haptonic.names.variable`."""
    passed(dataset)
    every = (*dataset.variables, *dataset.dims)
    names = {name: written for name in every if (written := variable(str(name))) != name}
    with hdf5.written(path) as file:
        dataset.rename(names).to_netcdf(file, engine="h5netcdf")


def stamped(dataset: xr.Dataset, inputs: Mapping[str, Any]) -> xr.Dataset:
    """The dataset, its numbers looked at, with the inputs, the version and the code that made it."""
    dataset.attrs |= {
        "inputs": json.dumps(inputs),
        "haptonic_version": version("haptonic"),
        "code_fingerprint": fingerprint(),
        "origin": "simulated",
    }
    return passed(dataset)
