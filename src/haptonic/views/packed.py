"""A view as bytes: a header in JSON, then the arrays."""

from __future__ import annotations

import json
import struct
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from importlib.resources import files
from typing import Any

import numpy as np

from haptonic.gate import passed
from haptonic.later import xarray as xr

PROGRAM = "views.js"
ALIGNED = 8  # bytes; arrays begin at multiples, as the browser's typed arrays require
STEPS = np.iinfo(np.int16).max
FORMS = {"f": (np.float64, np.float32), "i": (np.int32, np.int8), "u": (np.int32,), "b": (np.int32,)}


@dataclass(frozen=True, eq=False)
class InteractiveView:
    """Contents of an interactive view.

    kind : name of the view, as in ``web/src/views.ts``
    title : heading
    dataset : numbers, each variable with ``units`` and ``long_name``
    extra : sentences, colours and limits, in a form for JSON
    short : variables that are stored with 16 bits, to 3e-5 of their largest value
    """

    kind: str
    title: str
    dataset: xr.Dataset
    extra: Mapping[str, Any] = field(default_factory=dict)
    short: Sequence[str] = ()


def packed(view: InteractiveView) -> bytes:
    """The view as bytes: length of the header (4 bytes, little-endian), header, arrays.

    The header lists for each variable its dimensions, shape, type, position behind the header and attributes;
    texts are in the header. Integers have 32 or 8 bits. Variables of ``short`` are integers of 16 bits times
    ``scale``.
    """
    data = passed(view.dataset)
    variables, blocks, start = dict[str, Any](), list[bytes](), 0
    for name, variable in data.variables.items():
        values = np.ascontiguousarray(variable.values)
        about: dict[str, Any] = {
            "dims": variable.dims,
            "shape": variable.shape,
            "attrs": {key: str(value) for key, value in variable.attrs.items()},
        }
        variables[str(name)] = about
        if values.dtype.kind in "UO":
            about["texts"] = values.ravel().tolist()
            continue
        if name in view.short:
            scale = float(np.abs(values).max(initial=0.0)) / STEPS or 1.0
            values, about["scale"] = np.rint(values / scale).astype(np.int16), scale
        elif values.dtype not in FORMS[values.dtype.kind]:
            values = values.astype(FORMS[values.dtype.kind][0])
        little = values.astype(values.dtype.newbyteorder("<"), copy=False)
        about |= {"type": little.dtype.str, "start": start}
        blocks.append(_padded(little.tobytes()))
        start += len(blocks[-1])
    header = {
        "kind": view.kind,
        "title": view.title,
        "extra": view.extra,
        "attrs": {name: value for name, value in data.attrs.items() if isinstance(value, str | int | float)},
        "variables": variables,
    }
    text = json.dumps(header, ensure_ascii=False, allow_nan=False).encode("utf-8", "replace")
    front = struct.pack("<I", len(text)) + text
    return b"".join([_padded(front), *blocks])


def header_of(content: bytes) -> dict[str, Any]:
    """The header of a packed view."""
    (length,) = struct.unpack_from("<I", content)
    header: dict[str, Any] = json.loads(content[4 : 4 + length])
    return header


def compressed(content: bytes) -> bytes:
    """A packed view, compressed by zlib."""
    return zlib.compress(content, 6)


def program() -> str:
    """The program that shows views on pages and in notebooks, an ES module."""
    return files("haptonic.views").joinpath("bundle", PROGRAM).read_text("utf-8")


def _padded(content: bytes) -> bytes:
    return content + bytes(-len(content) % ALIGNED)
