"""Mode shapes and vibrations in VTK's unstructured format, for ParaView and similar programs."""

from __future__ import annotations

import json
import zlib
from base64 import b64encode
from collections.abc import Mapping
from html import escape
from math import prod
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from haptonic.atomic import refuse_overwrite, write_atomically
from haptonic.later import xarray as xr

HEXAHEDRON = 12  # number of this form in VTK
TYPES = {"f4": "Float32", "f8": "Float64", "i8": "Int64", "u1": "UInt8"}


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
    cells = dataset["subcell"].values
    cells_of_each = [
        prod(p) for number, *p in json.loads(dataset.attrs["element_grids"]) for _ in range(number)
    ]
    fields = {}
    for k in range(dataset.sizes["mode"]):
        name = f"M{k + 1} {float(dataset['mode_frequency'][k]) / 1e3:.2f} kHz"
        fields[f"{name} real"] = dataset["mode_real"].values[k]
        fields[f"{name} imaginary"] = dataset["mode_imag"].values[k]
    number = np.repeat(np.arange(len(cells_of_each)), cells_of_each)
    content = _file(dataset["node_position"].values, cells, fields, {"element": number})
    write_atomically(path, lambda temporary: temporary.write_bytes(content))
    return path


def write_body(path: Path, dataset: xr.Dataset) -> None:
    """Write the displacement of a whole plate, real and imaginary, m per unit of the reference.

    Parameters
    ----------
    dataset : with ``node_position``, ``subcell``, ``real`` and ``imag``, as in a plate's result
    """
    parts = {"displacement real": dataset["real"].values, "displacement imaginary": dataset["imag"].values}
    path.write_bytes(_file(dataset["node_position"].values, dataset["subcell"].values, parts, {}))


def _file(
    points: NDArray[np.floating],
    cells: NDArray[np.int64],
    on_points: Mapping[str, NDArray[np.floating]],
    on_cells: Mapping[str, NDArray[np.int64]],
) -> bytes:
    """Content of a file with hexahedra; meshio writes the same, but its import takes longer than the rest.

    Parameters
    ----------
    points : (n, 3) m; cells : (m, 8) corners in VTK's order
    on_points : (n, 3) fields; on_cells : (m,) numbers, by name
    """
    of_cells: dict[str, NDArray[np.number]] = {
        "connectivity": cells.ravel(),
        "offsets": 8 * np.arange(1, len(cells) + 1),
        "types": np.full(len(cells), HEXAHEDRON, dtype=np.uint8),
    }
    body = "\n".join(
        f"<{group}>\n{''.join(_array(name, values) for name, values in arrays.items())}</{group}>"
        for group, arrays in (
            ("Points", {"Points": points}),
            ("Cells", of_cells),
            ("PointData", on_points),
            ("CellData", on_cells),
        )
    )
    return (
        '<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian" '
        'compressor="vtkZLibDataCompressor">\n<UnstructuredGrid>\n'
        f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">\n{body}\n</Piece>\n'
        "</UnstructuredGrid>\n</VTKFile>\n"
    ).encode()


def _array(name: str, values: NDArray[np.number]) -> str:
    """Element of an array as one compressed block, after the number of blocks and their sizes in bytes."""
    kind = f"{values.dtype.kind}{values.dtype.itemsize}"
    data = values.astype(f"<{kind}").tobytes()
    packed = zlib.compress(data)
    sizes = np.array([1, len(data), len(data), len(packed)], dtype="<u4")
    about = f'type="{TYPES[kind]}" Name="{escape(name)}" format="binary"'
    about += f' NumberOfComponents="{values.shape[1]}"' if values.ndim > 1 else ""
    return f"<DataArray {about}>{(b64encode(sizes.tobytes()) + b64encode(packed)).decode()}</DataArray>\n"
