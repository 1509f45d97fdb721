"""Modes at wavevectors of a band diagram and of the zone, on the surface of the cell, for views that move."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from haptonic.arrays import Array, Complex
from haptonic.bloch.model import BlochModel
from haptonic.bloch.tracking import Diagram
from haptonic.bloch.zone import ZoneModes
from haptonic.cell.skin import drawing_cells, outer_faces, outline_edges
from haptonic.gate import titled
from haptonic.later import xarray as xr

# Smallest singular values that are kept, relative to the largest: of the unknowns, which only saves time, and
# of the displacements. A mode is then within 1e-3 of its largest displacement, less than the width of a line.
RANK, KEPT = 1e-9, 1e-4
AT_ONCE = 500  # modes on all nodes in memory


def path_modes(model: BlochModel, along: Diagram, zone: ZoneModes | None = None) -> xr.Dataset:
    """Displacement of the surface of the cell for all modes of a diagram, and for those over the zone.

    A mode is a sum of real shapes, ``u = sum_s (real_s + i imag_s) shape_s``, with the largest displacement
    1. The modes of a cell are so much alike that about a hundred shapes describe them all (singular value
    decomposition).

    Returns
    -------
    dataset with dimensions ``wavevector``, ``band``, ``shape``, ``skin_node``, ``face``, ``edge``, and
    ``zone_point`` with ``zone``
    """
    tiling = model.fine.tiling
    cells, _ = drawing_cells(
        tiling.linear_subcells(), [list(grid) for mesh in tiling.meshes for grid in mesh.grids()]
    )
    faces = outer_faces(cells)
    used, corners = np.unique(faces, return_inverse=True)
    position, faces = tiling.points[used], corners.reshape(faces.shape)
    every = along.fields if zone is None else np.hstack([along.fields, zone.fields])
    shapes, amplitudes = _separated(lambda unknowns: tiling.lifted(unknowns)[used], every)
    of_path, of_zone = np.split(amplitudes.T.astype(np.complex64), [along.fields.shape[1]])
    by_mode = of_path.reshape(*along.frequency.shape, -1)
    of_modes = ("wavevector", "band", "shape")
    of_shapes, shapes = ("shape", "skin_node", "xyz"), shapes.astype(np.float32)
    edges, earlier = outline_edges(position, faces), "a quarter period earlier"
    variables: dict[str, tuple[Sequence[str], Any, str, str]] = {
        "skin_position": (
            of_shapes[1:], position, "m", "position of the nodes on the surface of the cell",
        ),
        "skin_face": (("face", "skin_corner"), faces, "1", "four corners of each face of the surface"),
        "skin_edge": (("edge", "skin_end"), edges, "1", "two ends of each edge of the body"),
        "path_shape": (of_shapes, shapes, "1", "displacement of a shape, largest component 1"),
        "path_mode_real": (of_modes, by_mode.real, "1", "share of a shape in the displacement in phase"),
        "path_mode_imag": (of_modes, by_mode.imag, "1", f"share of a shape in the displacement {earlier}"),
    }  # fmt: skip
    if zone is not None:
        by_mode, of_modes = of_zone.reshape(*zone.character.shape, -1), ("zone_point", *of_modes[1:])
        variables["zone_mode_real"] = of_modes, by_mode.real, "1", "the same over the zone, in phase"
        variables["zone_mode_imag"] = of_modes, by_mode.imag, "1", f"the same over the zone, {earlier}"
    return titled(variables)


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
    modes /= np.linalg.norm(modes, axis=0)
    vectors, values = _directions(modes)
    vectors = vectors[:, values > KEPT * values[0]]
    shapes, modes = basis @ vectors, vectors.T @ modes
    for start in range(0, modes.shape[1], AT_ONCE):
        some = modes[:, start : start + AT_ONCE]
        moved = (shapes @ some).reshape(nodes, 3, -1)
        some /= np.linalg.norm(moved, axis=1).max(axis=0)
        some *= np.exp(-0.5j * np.angle((moved**2).sum(axis=(0, 1))))
    largest = np.abs(shapes).max(axis=0)
    return np.moveaxis((shapes / largest).reshape(nodes, 3, -1), 2, 0), largest[:, None] * modes


def _directions(fields: Complex) -> tuple[Array, Array]:
    """Orthonormal real vectors (n, r) that span the fields (n, m), and their singular values (r,)."""
    vectors, values, _ = np.linalg.svd(np.hstack([fields.real, fields.imag]), full_matrices=False)
    return vectors, values
