"""Mode shapes and vibrations in VTK's unstructured format, for ParaView and similar programs.

The file is written here because meshio compresses all of it, which shrinks fields by two fifths and takes
six times as long.
"""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Iterator, Mapping
from math import prod
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Ints
from haptonic.atomic import refuse_overwrite, write_atomically
from haptonic.later import xarray as xr

HEXAHEDRON = 12  # VTK's number of this type of cell
TYPES = {"f4": "Float32", "f8": "Float64", "i4": "Int32", "i8": "Int64", "u1": "UInt8"}


def write_modes(path: Path, dataset: xr.Dataset, overwrite: bool = False) -> Path:
    """Write the mode shapes of a result as one file.

    The mesh consists of the small hexahedra between the nodes, in m. Each mode is a pair of vector fields on
    the nodes, with names such as ``M1 7.66 kHz real`` and ``M1 7.66 kHz imaginary``, with the largest
    component 1. The integer field ``element`` gives the number of the spectral element of each small
    hexahedron.

    Parameters
    ----------
    dataset : from `haptonic.bloch.bands_dataset`

    Raises
    ------
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    cells_of_each = [
        prod(p) for number, *p in json.loads(dataset.attrs["element_grids"]) for _ in range(number)
    ]
    fields = {}
    for k in range(dataset.sizes["mode"]):
        name = f"M{k + 1} {float(dataset['mode_frequency'][k]) / 1e3:.2f} kHz"
        fields[f"{name} real"] = dataset["mode_real"].values[k]
        fields[f"{name} imaginary"] = dataset["mode_imag"].values[k]
    element = np.repeat(np.arange(len(cells_of_each)), cells_of_each)
    write_atomically(path, lambda temporary: _write(temporary, dataset, fields, {"element": element}))
    return path


def write_body(path: Path, dataset: xr.Dataset) -> None:
    """Write the displacement of a whole plate, real and imaginary, m per unit of the reference.

    Parameters
    ----------
    dataset : with ``node_position``, ``subcell``, ``real`` and ``imag``, as in a plate's result
    """
    parts = {"real": "real", "imaginary": "imag"}
    _write(path, dataset, {f"displacement {part}": dataset[name].values for part, name in parts.items()}, {})


def _write(
    path: Path, dataset: xr.Dataset, at_nodes: Mapping[str, Array], in_cells: Mapping[str, Ints]
) -> None:
    """Write the mesh of a dataset with vector fields at its nodes and numbers of its hexahedra."""
    cells = dataset["subcell"].values
    count, corners = cells.shape
    mesh = {
        "connectivity": cells.ravel(),
        "offsets": np.arange(corners, corners * (count + 1), corners),
        "types": np.full(count, HEXAHEDRON, np.uint8),
    }
    groups = {"Points": {"Points": dataset["node_position"].values}, "Cells": mesh,
              "PointData": at_nodes, "CellData": in_cells}  # fmt: skip
    with path.open("w", encoding="ascii") as out:
        out.write(
            '<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian" '
            'compressor="vtkZLibDataCompressor">\n<UnstructuredGrid>\n'
            f'<Piece NumberOfPoints="{dataset.sizes["node"]}" NumberOfCells="{count}">\n'
        )
        for group, arrays in groups.items():
            out.write(f"<{group}>\n")
            out.writelines(line for name, values in arrays.items() for line in _array(name, values))
            out.write(f"</{group}>\n")
        out.write("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")


def _array(name: str, values: NDArray[np.generic]) -> Iterator[str]:
    """Lines of an array: base64 of a header, and of one block in zlib's format.

    Numbers of nodes and cells are compressed tenfold; fields are stored as they are.
    """
    is_field = values.dtype.kind == "f"
    kind = TYPES[values.dtype.str[1:]]
    components = f' NumberOfComponents="{values.shape[1]}"' if values.ndim > 1 else ""
    content = np.ascontiguousarray(values, values.dtype.newbyteorder("<")).tobytes()
    block = zlib.compress(content, 0 if is_field else 1)
    # number of blocks, size of each and of the last, and compressed sizes
    header = np.array([1, len(content), len(content), len(block)], "<u4")
    yield f'<DataArray type="{kind}" Name="{name}"{components} format="binary">\n'
    for part in (header.tobytes(), block):
        yield base64.b64encode(part).decode()
    yield "\n</DataArray>\n"
