"""Modes at every wavevector of a band diagram, on the surface of the cell, for views that move."""

from __future__ import annotations

import json

import numpy as np

from haptonic.bloch.model import best_model
from haptonic.bloch.settings import BandSettings
from haptonic.bloch.tracking import diagram
from haptonic.cell import UnitCell
from haptonic.cell.skin import drawing_cells, outer_faces, outline_edges
from haptonic.later import xarray as xr
from haptonic.parallel import one_thread

# Smallest singular value of the modes' unknowns that is kept, relative to the largest. On the reference cell
# the displacement of a mode is then within 2e-4 of its largest value, less than the width of a drawn line.
KEPT = 1e-5


@one_thread()
def path_modes(cell: UnitCell, settings: BandSettings) -> xr.Dataset:
    """Displacement of the surface of the cell for all modes of `haptonic.bloch.bands_dataset`.

    A mode is a sum of real shapes, ``u = sum_s (real_s + i imag_s) shape_s``, with the largest displacement 1.
    The modes of a diagram are so much alike that about a hundred shapes describe them all (singular value
    decomposition).

    Returns
    -------
    dataset with dimensions ``wavevector``, ``band``, ``shape``, ``skin_node``, ``skin_face``, ``skin_edge``

    Raises
    ------
    ResourceError : as `haptonic.bloch.bands_dataset`
    """
    model = best_model(cell, settings).model
    path = cell.zone.path(settings.points)
    fields = diagram(model, path).fields
    tiling = model.fine.tiling
    cells, _ = drawing_cells(
        tiling.linear_subcells(), [grid for mesh in tiling.meshes for grid in mesh.grids()]
    )
    faces = outer_faces(cells)
    used, corners = np.unique(faces, return_inverse=True)
    position, faces = tiling.points[used], corners.reshape(faces.shape)
    vectors, values, _ = np.linalg.svd(np.hstack([fields.real, fields.imag]), full_matrices=False)
    vectors = vectors[:, values > KEPT * values[0]]
    shapes = np.moveaxis(tiling.lifted(vectors)[used], 2, 0)
    largest = np.abs(shapes).max(axis=(1, 2))
    shapes /= largest[:, None, None]
    amplitudes = (vectors * largest).T @ fields
    moved = np.einsum("sm,snx->mnx", amplitudes, shapes)
    amplitudes /= np.linalg.norm(moved, axis=2).max(axis=1)
    amplitudes *= np.exp(-0.5j * np.angle((moved**2).sum(axis=(1, 2))))  # the largest real part
    by_mode = amplitudes.T.reshape(len(path.kappa), -1, len(shapes)).astype(np.complex64)
    of_modes = ("wavevector", "band", "shape")
    dataset = xr.Dataset(
        {
            "skin_position": (("skin_node", "xyz"), position),
            "skin_face": (("skin_face", "skin_corner"), faces),
            "skin_edge": (("skin_edge", "skin_end"), outline_edges(position, faces)),
            "path_shape": (("shape", "skin_node", "xyz"), shapes.astype(np.float32)),
            "path_mode_real": (of_modes, by_mode.real),
            "path_mode_imag": (of_modes, by_mode.imag),
        },
        attrs={"lattice_vectors": json.dumps(cell.lattice.vectors.tolist())},
    )
    for name, (unit, title) in {
        "skin_position": ("m", "position of the nodes on the surface of the cell"),
        "skin_face": ("1", "four corners of each face of the surface"),
        "skin_edge": ("1", "two ends of each edge of the body"),
        "path_shape": ("1", "displacement of a shape, largest component 1"),
        "path_mode_real": ("1", "share of a shape in the displacement in phase"),
        "path_mode_imag": ("1", "share of a shape in the displacement a quarter period earlier"),
    }.items():
        dataset[name].attrs = {"units": unit, "long_name": title}
    return dataset
