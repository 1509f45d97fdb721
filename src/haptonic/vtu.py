"""Mode shapes and vibrations in VTK's unstructured format, for ParaView and similar programs."""

from __future__ import annotations

import json
from math import prod
from pathlib import Path

import numpy as np

from haptonic.atomic import refuse_overwrite, write_atomically
from haptonic.later import meshio, xarray as xr


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
    mesh = meshio.Mesh(
        dataset["node_position"].values,
        [("hexahedron", cells)],
        point_data=fields,
        cell_data={"element": [np.repeat(np.arange(len(cells_of_each)), cells_of_each)]},
    )
    write_atomically(path, lambda temporary: mesh.write(temporary, file_format="vtu"))
    return path


def write_body(path: Path, dataset: xr.Dataset) -> None:
    """Write the displacement of a whole plate, real and imaginary, m per unit of the reference.

    Parameters
    ----------
    dataset : with ``node_position``, ``subcell``, ``real`` and ``imag``, as in a plate's result
    """
    mesh = meshio.Mesh(
        dataset["node_position"].values,
        [("hexahedron", dataset["subcell"].values)],
        point_data={
            "displacement real": dataset["real"].values,
            "displacement imaginary": dataset["imag"].values,
        },
    )
    mesh.write(path, file_format="vtu")
