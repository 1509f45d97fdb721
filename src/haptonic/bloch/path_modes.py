"""Modes at every wavevector of a band diagram, on the surface of the cell, for views that move."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from haptonic.arrays import Array, Complex
from haptonic.bloch.model import BlochModel
from haptonic.bloch.tracking import Diagram
from haptonic.cell.skin import drawing_cells, outer_faces, outline_edges
from haptonic.later import xarray as xr

# Smallest singular values that are kept, relative to the largest: of the unknowns, which only saves time, and
# of the displacements. A mode is then within 1e-3 of its largest displacement, less than the width of a line.
RANK, KEPT = 1e-9, 1e-4


def path_modes(model: BlochModel, along: Diagram) -> xr.Dataset:
    """Displacement of the surface of the cell for all modes of a diagram.

    A mode is a sum of real shapes, ``u = sum_s (real_s + i imag_s) shape_s``, with the largest displacement
    1. The modes of a diagram are so much alike that less than a hundred shapes describe them all (singular
    value decomposition).

    Returns
    -------
    dataset with dimensions ``wavevector``, ``band``, ``shape``, ``skin_node``, ``face``, ``edge``
    """
    tiling = model.fine.tiling
    cells, _ = drawing_cells(
        tiling.linear_subcells(), [list(grid) for mesh in tiling.meshes for grid in mesh.grids()]
    )
    faces = outer_faces(cells)
    used, corners = np.unique(faces, return_inverse=True)
    position, faces = tiling.points[used], corners.reshape(faces.shape)
    shapes, amplitudes = _separated(lambda unknowns: tiling.lifted(unknowns)[used], along.fields)
    by_mode = amplitudes.T.reshape(len(along.path.kappa), -1, len(shapes)).astype(np.complex64)
    of_modes = ("wavevector", "band", "shape")
    dataset = xr.Dataset(
        {
            "skin_position": (("skin_node", "xyz"), position),
            "skin_face": (("face", "skin_corner"), faces),
            "skin_edge": (("edge", "skin_end"), outline_edges(position, faces)),
            "path_shape": (("shape", "skin_node", "xyz"), shapes.astype(np.float32)),
            "path_mode_real": (of_modes, by_mode.real),
            "path_mode_imag": (of_modes, by_mode.imag),
        }
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


def _separated(lifted: Callable[[Array], Array], fields: Complex) -> tuple[Array, Complex]:
    """Shapes (s, nodes, 3), largest component 1, and amplitudes (s, m) of modes with fields (n, m).

    Each mode is scaled to the largest displacement 1, and turned to the phase with the largest real part.
    """
    vectors, values = _directions(fields)
    vectors = vectors[:, values > RANK * values[0]]
    spanned = lifted(vectors)
    nodes = len(spanned)
    basis, triangle = np.linalg.qr(spanned.reshape(3 * nodes, -1))
    modes = triangle @ (vectors.T @ fields)
    moved = (basis @ modes).reshape(nodes, 3, -1)
    modes /= np.linalg.norm(moved, axis=1).max(axis=0)
    modes *= np.exp(-0.5j * np.angle((moved**2).sum(axis=(0, 1))))
    vectors, values = _directions(modes)
    vectors = vectors[:, values > KEPT * values[0]]
    shapes = basis @ vectors
    largest = np.abs(shapes).max(axis=0)
    amplitudes = largest[:, None] * (vectors.T @ modes)
    return np.moveaxis((shapes / largest).reshape(nodes, 3, -1), 2, 0), amplitudes


def _directions(fields: Complex) -> tuple[Array, Array]:
    """Orthonormal real vectors (n, r) that span the fields (n, m), and their singular values (r,)."""
    vectors, values, _ = np.linalg.svd(np.hstack([fields.real, fields.imag]), full_matrices=False)
    return vectors, values
