"""Parts that all results share: the inputs, a key in the store, a stamp, and files that are whole."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from importlib.metadata import version
from pathlib import Path, PurePosixPath
from typing import Any

from haptonic import hdf5
from haptonic.atomic import draft_for, refuse_overwrite, write_atomically
from haptonic.bloch.mesh_levels import rounded_up
from haptonic.bloch.settings import COARSEST
from haptonic.errors import shown
from haptonic.gate import passed
from haptonic.later import xarray as xr
from haptonic.names import variable
from haptonic.paths import inside
from haptonic.store import fingerprint
from haptonic.units import duration, in_percent

Writer = Callable[[Path], object]


REASONS = {
    "time": "lack of time",
    "memory": "lack of memory",
    "range": "range of validity",
    "bands": "the number of bands",
    "ribbon": "the mesh, which is that of the cells' bands",
}


def accuracy_remarks(attributes: Mapping[str, Any]) -> list[str]:
    """Warnings on errors: those of a mesh's shape, and a required accuracy that was not reached.

    attributes : of a dataset; see `haptonic.bloch.candidates.BestModel.attributes`
    """
    remarks = []
    if (name := attributes.get("straight_mesh")) is not None:
        remarks.append(
            f"All edges in {shown(name, 60)} are straight. Round outlines are polygons in such a mesh, and "
            "the errors do not include the difference."
        )
    asked, largest = attributes.get("accuracy"), attributes.get("largest_error")
    if asked is None or largest is None or largest <= asked:
        return remarks
    reached = in_percent(rounded_up(largest), form="g") if largest > COARSEST else f"{rounded_up(largest):g}"
    remark = (
        f"The required accuracy, {asked:g}, is not reached: errors go up to {reached} of a frequency"
        f"{', too large to judge gaps' if largest > COARSEST else ''}."
    )
    if "stopped_by" in attributes:
        remark += f" The reason is {REASONS[attributes['stopped_by']]}: {attributes['stopped_why']}."
    else:
        remark += " The study sets the mesh in [mesh]; without it, the accuracy determines the mesh."
    if "budget_needed_s" in attributes:
        remark += f' Run again with --budget "{duration(attributes["budget_needed_s"])}" for the next mesh.'
    if largest <= COARSEST and attributes.get("stopped_by") != "ribbon":  # a study accepts no larger number
        remark += f" To accept these errors, set accuracy = {reached} in [bands]."
    return [*remarks, remark]


def write_files(folder: Path, writers: Mapping[Any, Writer], *, overwrite: bool) -> list[Path]:
    """Write files into a folder, each whole or not at all, and none if one of them may not be written.

    Names are texts, or paths below the folder; see `haptonic.paths.inside`.
    """
    refuse_taken(folder, writers, overwrite=overwrite)
    paths = [inside(folder, name) for name in writers]
    for path, writer in zip(paths, writers.values(), strict=True):
        write_atomically(path, writer)
    return paths


def refuse_taken(folder: Path | None, names: Iterable[str | PurePosixPath], *, overwrite: bool) -> None:
    """Raise ResourceError if a name is taken or leads out of the folder, or if it cannot be written.

    It is called before the work starts, so that no run fails on its last step. A folder that does not exist
    is not created, because a later check may refuse the command.
    """
    if folder is None:
        return
    for name in names:
        refuse_overwrite(inside(folder, name), overwrite)
    with draft_for(folder) as (draft, rest):
        write_atomically(draft / rest / "probe", Path.touch)


def write_netcdf(dataset: xr.Dataset, path: Path) -> None:
    """Write NetCDF 4; names of regions in variables are encoded, see `haptonic.names`."""
    passed(dataset)
    every = (*dataset.variables, *dataset.dims)
    names = {name: in_file for name in every if (in_file := variable(str(name))) != name}
    hdf5.write_dataset(dataset.rename(names), path)


def stamped(dataset: xr.Dataset, inputs: Mapping[str, Any]) -> xr.Dataset:
    """Check the numbers of a dataset and add the inputs, the version and the fingerprint of the code."""
    dataset.attrs |= {
        "inputs": json.dumps(inputs),
        "haptonic_version": version("haptonic"),
        "code_fingerprint": fingerprint(),
        "origin": "simulated",
    }
    return passed(dataset)
