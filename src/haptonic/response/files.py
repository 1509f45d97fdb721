"""Frequency responses in NetCDF files.

NetCDF has no complex numbers, so a file contains ``response_real`` and ``response_imag``, which any NetCDF
reader understands.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic import hdf5
from haptonic.channels.hdf5 import arrays_of, refuse_sizes
from haptonic.errors import ChannelError, ResourceError, ResponseError
from haptonic.foreign.process import ask
from haptonic.gate import json_from, passed
from haptonic.later import xarray as xr
from haptonic.paths import source
from haptonic.response.checks import DIRECTIONS
from haptonic.response.value import FrequencyResponse

KIND = "haptonic frequency response"
DIMENSIONS = {
    **dict.fromkeys(("response_real", "response_imag"), ("line", "point", "direction")),
    "frequency": ("line",), "x": ("point",), "y": ("point",), "direction": ("direction",),
    "coherence": ("line", "point"), "region": ("point",),
}  # fmt: skip
PARTS = tuple(DIMENSIONS)
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
    """Write a response as NetCDF 4. `haptonic.atomic.write_atomically` writes a complete file or none."""
    hdf5.write_dataset(passed(plain(response)), path)


def read(path: Path | str) -> FrequencyResponse:
    """Read a response into memory, from a file written by `write`.

    Raises
    ------
    ResourceError : no such file, or one that cannot be read
    ResponseError : the file is of another kind, or damaged
    """
    path = source(path, "file of a frequency response")
    try:
        content = ask("hdf5.tree", path, deep=False)
        attributes = content["attributes"]
        if not is_response(attributes):
            raise _foreign(path, "a NetCDF file of another kind")
        if int(attributes["form"]) > FORM:
            raise _foreign(path, f"form {attributes['form']} of the file, from a later haptonic")
        if any(name in content["elsewhere"] for name in PARTS):
            raise _foreign(path, "links to another file, which are not followed")
        _check_sizes(path, content["sets"])
        return _assembled(
            arrays_of(path, content, [name for name in PARTS if name in content["sets"]]), attributes
        )
    except FileNotFoundError as error:
        next_step = "check the name and the folder"
        raise _refused("not-found", path, "there is no such file", next_step) from error
    except (PermissionError, IsADirectoryError) as error:
        cause = "it is a folder, or you may not read it"
        raise _refused("unreadable", path, cause, "choose a readable file") from error
    except MemoryError as error:
        cause = "it does not fit into memory, or it is damaged"
        raise _refused("too-large", path, cause, "copy it again") from error
    except ChannelError as error:
        raise _foreign(path, f"not a NetCDF 4 file, or one that is damaged ({error.given})") from error
    except (KeyError, ValueError, TypeError, AttributeError, OverflowError) as error:
        raise _foreign(path, f"a part is missing or damaged ({type(error).__name__})") from error


def is_response(attributes: Mapping[str, Any]) -> bool:
    """True for attributes of a file written by `write`."""
    kind = attributes.get("kind")
    return isinstance(kind, str) and kind == KIND


def _check_sizes(path: Path, sets: Mapping[str, Mapping[str, Any]]) -> None:
    """Refuse parts whose kinds or sizes are not those of a response, before any of them is read."""
    refuse_sizes(path, sets, DIMENSIONS)
    for name in DIMENSIONS:
        kind = "text" if name in ("direction", "region") else "number"
        if name in sets and sets[name]["kind"] != kind:
            raise _foreign(path, f"{name} is {sets[name]['kind']}, not {kind}")
    if "direction" in sets and sets["direction"]["shape"][0] > len(DIRECTIONS):
        raise _foreign(path, f"{sets['direction']['shape'][0]} directions")


def from_plain(data: xr.Dataset) -> FrequencyResponse:
    """Make the response of a dataset from `plain`."""
    return _assembled({name: data[name].values for name in PARTS if name in data.variables}, data.attrs)


def _assembled(parts: Mapping[str, NDArray[Any]], notes: Mapping[Any, Any]) -> FrequencyResponse:
    real, imaginary = parts["response_real"], parts["response_imag"]
    values = np.empty(real.shape, dtype=np.result_type(real.dtype, np.complex64))
    values.real, values.imag = real, imaginary
    assembled = FrequencyResponse.of(
        values,
        frequency=parts["frequency"],
        x=parts["x"],
        y=parts["y"],
        direction=[str(name) for name in parts["direction"]],
        quantity=notes["quantity"],
        reference=notes["reference"],
        origin=notes["origin"],
        coherence=parts.get("coherence"),
        region=[str(name) for name in parts["region"]] if "region" in parts else None,
        title=notes["title"],
        inputs=json_from(notes["inputs"]),
    )
    return FrequencyResponse(assembled.dataset.assign_attrs(haptonic_version=notes["haptonic_version"]))


def _foreign(path: Path, given: str) -> ResponseError:
    return ResponseError.unreadable(
        argument="file of a frequency response",
        given=f"{path}: {given}",
        allowed="a file that haptonic wrote, or made from a scan",
        cause="the wrong file was chosen, or a copy was interrupted",
        next_step="choose another file, or import the scan again",
    )


def _refused(code: str, path: Path, cause: str, next_step: str) -> ResourceError:
    return ResourceError(
        code,
        argument="file of a frequency response",
        given=path,
        allowed="a file that can be read",
        cause=cause,
        next_step=next_step,
    )
