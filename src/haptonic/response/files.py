"""Frequency responses in NetCDF files.

NetCDF has no complex numbers, so a file holds ``response_real`` and ``response_imag``; any NetCDF reader
understands it.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from haptonic import hdf5
from haptonic.errors import HaptonicError, ResourceError, ResponseError
from haptonic.response.value import FrequencyResponse

KIND = "haptonic frequency response"
FORM = 1  # of the file; a larger one comes from a later haptonic


def plain(response: FrequencyResponse) -> xr.Dataset:
    """The response as a dataset without complex numbers."""
    data = response.dataset
    values = data["response"]
    notes = {"comment": "response = response_real + i response_imag"}
    parts = {
        f"response_{name}": (values.dims, part, values.attrs | notes)
        for name, part in (("real", values.values.real), ("imag", values.values.imag))
    }
    return data.drop_vars("response").assign(parts).assign_attrs(kind=KIND, form=FORM)


def write(response: FrequencyResponse, path: Path) -> None:
    """Write a response as NetCDF 4. `haptonic.store.write_atomically` makes the file whole or not at all."""
    data = plain(response)
    numbers = [name for name, variable in data.variables.items() if variable.dtype.kind == "f"]
    encoding = {name: {"_FillValue": None} for name in numbers}
    with hdf5.written(path) as file:
        data.to_netcdf(file, engine="h5netcdf", encoding=encoding)


def read(path: Path) -> FrequencyResponse:
    """A response, in memory, from a file that `write` made.

    Raises
    ------
    ResourceError : there is no such file, or it cannot be read
    ResponseError : the file is of another kind, or damaged
    """
    try:
        with xr.open_dataset(path, engine="h5netcdf", decode_timedelta=False) as data:
            if data.attrs.get("kind") != KIND:
                raise _foreign(path, "a NetCDF file of another kind")
            if data.attrs["form"] > FORM:
                raise _foreign(path, f"form {data.attrs['form']} of the file, from a later haptonic")
            return from_plain(data)
    except FileNotFoundError as error:
        raise _unreadable(path, "there is no such file", "check the name and the folder") from error
    except (PermissionError, IsADirectoryError) as error:
        raise _unreadable(path, "it is a folder, or you may not read it", "choose a readable file") from error
    except HaptonicError:
        raise
    except (OSError, KeyError, ValueError, TypeError) as error:
        raise _foreign(path, "not a NetCDF 4 file, or one that is damaged") from error


def from_plain(data: xr.Dataset) -> FrequencyResponse:
    real, imaginary = data["response_real"], data["response_imag"]
    values = np.empty(real.shape, dtype=np.result_type(real.dtype, np.complex64))
    values.real, values.imag = real.values, imaginary.values
    notes: dict[str, Any] = dict(data.attrs)
    made = FrequencyResponse.of(
        values,
        frequency=data["frequency"].values,
        x=data["x"].values,
        y=data["y"].values,
        direction=[str(name) for name in data["direction"].values],
        quantity=notes["quantity"],
        reference=notes["reference"],
        origin=notes["origin"],
        coherence=data["coherence"].values if "coherence" in data else None,
        region=[str(name) for name in data["region"].values] if "region" in data.coords else None,
        title=notes["title"],
        inputs=json.loads(notes["inputs"]),
    )
    return FrequencyResponse(made.dataset.assign_attrs(haptonic_version=notes["haptonic_version"]))


def _foreign(path: Path, found: str) -> ResponseError:
    return ResponseError(
        argument="file of a frequency response",
        given=f"{path}: {found}",
        allowed="a file that haptonic wrote, or made from a scan",
        cause="the wrong file was chosen, or a copy was interrupted",
        next_step="choose another file, or import the scan again",
    )


def _unreadable(path: Path, cause: str, next_step: str) -> ResourceError:
    return ResourceError(
        argument="file of a frequency response",
        given=path,
        allowed="a file that can be read",
        cause=cause,
        next_step=next_step,
    )
