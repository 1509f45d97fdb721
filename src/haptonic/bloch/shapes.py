"""Modes at one wavevector on all nodes of the cell."""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch.character import characters
from haptonic.bloch.model import BlochModel
from haptonic.bloch.symmetry import MIDDLE
from haptonic.gate import titled
from haptonic.later import xarray as xr


def mode_shapes(model: BlochModel, kappa: Array) -> xr.Dataset:
    """Fields of all modes at one wavevector on the meshes of all tiles, with linear sub-cells for drawing."""
    tiling = model.fine.tiling
    solution = model.solve(kappa)
    shapes = model.displacement(solution)
    largest = np.abs(shapes).max(axis=(0, 1))
    turned = shapes / largest
    for k in range(turned.shape[2]):  # choose the phase with the largest real part
        square = (turned[..., k] ** 2).sum()
        turned[..., k] *= np.exp(-0.5j * np.angle(square))
    named = characters(tiling, solution.fields, solution.values)
    fields, of_nodes = np.moveaxis(turned, 2, 0).astype(np.complex64), ("mode", "node", "xyz")
    cells = tiling.linear_subcells()
    return titled({
        "node_position": (("node", "xyz"), tiling.points, "m", "position of the mesh's nodes"),
        "subcell": (("cell", "corner"), cells, "1", "eight corners of linear cells between nodes"),
        "mode_frequency": ("mode", solution.frequency, "Hz", "frequency"),
        "mode_error": ("mode", solution.error, "Hz", "bound of the frequency's error"),
        "mode_name": ("mode", named.name, "1", "character, a position in character_names"),
        "mode_parity": ("mode", model.fine.parity(solution.modes), "1", MIDDLE),
        "mode_kappa": ("axis", kappa, "rad", "phases k . a1 and k . a2"),
        "mode_real": (of_nodes, fields.real, "1", "displacement in phase, largest component 1"),
        "mode_imag": (of_nodes, fields.imag, "1", "displacement a quarter period earlier"),
    })  # fmt: skip
